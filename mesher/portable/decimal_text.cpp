#include "mesher/portable/decimal_text.hpp"

#include <version>

namespace pcvt {

#if defined(__cpp_lib_to_chars)

char* write_decimal(char* begin, char* end, double value) {
    return std::to_chars(begin, end, value).ptr;
}

char* write_decimal(char* begin, char* end, float value) {
    return std::to_chars(begin, end, value).ptr;
}

char* write_decimal(char* begin, char* end, double value, std::chars_format format) {
    return std::to_chars(begin, end, value, format).ptr;
}

char* write_decimal(char* begin, char* end, double value, std::chars_format format, int precision) {
    return std::to_chars(begin, end, value, format, precision).ptr;
}

std::from_chars_result read_decimal(const char* begin, const char* end, double& value) {
    return std::from_chars(begin, end, value);
}

#else

char* write_decimal(char* begin, char* end, double value) {
    return by_c::write_decimal(begin, end, value);
}

char* write_decimal(char* begin, char* end, float value) {
    return by_c::write_decimal(begin, end, value);
}

char* write_decimal(char* begin, char* end, double value, std::chars_format format) {
    return by_c::write_decimal(begin, end, value, format);
}

char* write_decimal(char* begin, char* end, double value, std::chars_format format, int precision) {
    return by_c::write_decimal(begin, end, value, format, precision);
}

std::from_chars_result read_decimal(const char* begin, const char* end, double& value) {
    return by_c::read_decimal(begin, end, value);
}

#endif

}  // namespace pcvt
