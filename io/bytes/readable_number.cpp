#include "io/bytes/readable_number.hpp"

#include <array>

#include "mesher/portable/decimal_text.hpp"

namespace pcvt {

std::string figure(double value) {
    constexpr int kSignificantDigits = 6;
    std::array<char, 32> text;
    char* const end = write_decimal(text.data(), text.data() + text.size(), value,
                                    std::chars_format::general, kSignificantDigits);
    return {text.data(), end};
}

std::string counted(long n, const std::string& thing) {
    return std::to_string(n) + " " + thing + (n == 1 ? "" : "s");
}

}  // namespace pcvt
