#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "io/bytes/bad_file.hpp"

namespace pcvt {

/// May begin a text in UTF-8.
inline constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

/// Appends the shortest decimal number that reads back as `value`, in every locale; -0.0 is written
/// as 0.
///
/// Example usage:
///     std::string text = "v ";
///     append_number(text, 0.25);  // text is "v 0.25"
///     const double x = parse_number("0.25");
///
/// @throws InternalError if `value` is not finite: no text format here can represent it.
void append_number(std::string& text, double value);
/// The same for the number that reads back as `value` in single precision.
void append_number(std::string& text, float value);
void append_number(std::string& text, int value);

/// Returns the decimal number that the whole of `word` spells. A leading + is allowed; hexadecimal
/// numbers, NaN and infinity are not.
/// @throws InvalidInput such as `'1,5' is not a number; use a decimal point`.
double parse_number(std::string_view word);
/// The same for a whole number.
/// @throws InvalidInput such as `'1.5' is not a whole number; write one such as 12`.
int parse_integer(std::string_view word);

/// Returns `word` in quotes for a message: at most 40 characters of UTF-8, with question marks for
/// bytes that are not printable.
std::string in_quotes(std::string_view word);

/// Walks over the lines of a text. LF, CRLF and CR end a line, and so does the end of the text. A
/// UTF-8 byte order mark at the beginning is skipped.
///
/// Example usage:
///     LineScanner scanner("sites.txt", text);
///     while (scanner.next()) {
///         if (scanner.words().size() != 2) scanner.throw_bad_file("give two numbers a line");
///         const double x = scanner.number(scanner.words()[0]);
///     }
class LineScanner {
   public:
    /// @param name  the file's name in messages.
    /// @param text  must outlive the scanner.
    LineScanner(std::string name, std::string_view text);

    /// Advances to the next line; returns false at the end of the text.
    bool next();
    /// The number of the current line, counted from 1; 0 before the first next().
    int line() const { return line_; }
    /// The words of the current line, which blanks and tabs separate.
    const std::vector<std::string_view>& words() const { return words_; }
    /// The words of the current line before the first #.
    std::vector<std::string_view> words_before_comment() const;

    /// parse_number() and parse_integer() with file and line before the message.
    /// @throws BadFile `name:line: problem; remedy`.
    double number(std::string_view word) const;
    int integer(std::string_view word) const;
    /// @throws BadFile `name:line: complaint`.
    [[noreturn]] void throw_bad_file(const std::string& complaint) const;

   private:
    std::string name_;
    std::string_view rest_;
    std::vector<std::string_view> words_;
    int line_ = 0;
};

/// Returns the words of the current line before the first #.
std::vector<std::string_view> words_before_comment(const LineScanner& scanner);

/// Refuses a text that holds a NUL byte or begins with the byte order mark of UTF-16.
/// @throws BadFile `name:line: holds a NUL byte, so it appears to be a binary file; remedy`.
void refuse_binary(const std::string& name, std::string_view text, const std::string& remedy);

}  // namespace pcvt
