#pragma once

#include <charconv>

namespace pcvt {

/// Decimal numbers as std::to_chars and std::from_chars define them, also with a standard library
/// that has these only for integers (libc++ before version 14). Laws, tested by number:
///   (1) The text is that of std::to_chars, byte for byte.
///   (2) The number is that of std::from_chars, to the last bit, as are the end and the error.
///
/// Example usage:
///     std::array<char, 32> text;
///     char* const end = write_decimal(text.data(), text.data() + text.size(), 0.1);  // "0.1"
///
/// @pre  The text fits.
/// @returns  The end of the text.
char* write_decimal(char* begin, char* end, double value);
char* write_decimal(char* begin, char* end, float value);
char* write_decimal(char* begin, char* end, double value, std::chars_format format);
char* write_decimal(char* begin, char* end, double value, std::chars_format format, int precision);

std::from_chars_result read_decimal(const char* begin, const char* end, double& value);

/// The same by nothing but functions of C, for libraries without std::to_chars.
namespace by_c {
char* write_decimal(char* begin, char* end, double value);
char* write_decimal(char* begin, char* end, float value);
char* write_decimal(char* begin, char* end, double value, std::chars_format format);
char* write_decimal(char* begin, char* end, double value, std::chars_format format, int precision);
std::from_chars_result read_decimal(const char* begin, const char* end, double& value);
}  // namespace by_c

}  // namespace pcvt
