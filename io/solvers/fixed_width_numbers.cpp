#include "io/solvers/fixed_width_numbers.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <limits>

#include "io/bytes/text.hpp"
#include "mesher/portable/decimal_text.hpp"

namespace pcvt {
namespace {

/// More digits than a double has, and more than fit.
constexpr int kMostDigits = 20;

/// The most digits of `format` that fit; empty where not even one does.
std::string rounded(double value, std::chars_format format) {
    std::array<char, 400> digits{};
    for (int precision = kMostDigits; precision >= 0; --precision) {
        char* const end =
            write_decimal(digits.data(), digits.data() + digits.size(), value, format, precision);
        if (end - digits.data() <= static_cast<std::ptrdiff_t>(kFixedWidth)) {
            return {digits.data(), end};
        }
    }
    return {};
}

}  // namespace

FixedWidthNumbers::FixedWidthNumbers(double largest)
    : allowed_((std::nextafter(largest, std::numeric_limits<double>::infinity()) - largest) / 2) {}

bool FixedWidthNumbers::append(std::string& text, double value) const {
    const std::size_t before = text.size();
    append_number(text, value);
    if (text.size() - before <= kFixedWidth) return true;
    text.resize(before);
    std::string best;
    double least = allowed_;
    for (const auto format : {std::chars_format::fixed, std::chars_format::scientific}) {
        const std::string candidate = rounded(value, format);
        if (candidate.empty()) continue;
        const double error = std::abs(parse_number(candidate) - value);
        if (error > least || (!best.empty() && error == least)) continue;
        least = error;
        best = candidate;
    }
    text += best;
    return !best.empty();
}

}  // namespace pcvt
