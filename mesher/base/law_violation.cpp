#include "mesher/base/law_violation.hpp"

#include <array>
#include <charconv>

#include "mesher/portable/decimal_text.hpp"

namespace pcvt {

std::string violation_in_words(const std::string& law, const std::string& what) {
    return "law " + law + ": " + what;
}

void throw_violation(const std::string& law, const std::string& what) {
    throw NotATile(violation_in_words(law, what));
}

std::string in_words(double amount) {
    std::array<char, 32> text;
    char* const end = write_decimal(text.data(), text.data() + text.size(), amount,
                                    std::chars_format::general, 3);
    return {text.data(), end};
}

std::string edge_in_words(int from, int to) {
    return std::to_string(from) + " -> " + std::to_string(to);
}

}  // namespace pcvt
