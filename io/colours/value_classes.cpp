#include "io/colours/value_classes.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "mesher/portable/decimal_text.hpp"

namespace pcvt {
namespace {

/// The width of the finest classes, in octaves.
constexpr double kFinestClass = 1.0 / 16;

std::string rounded(double value, int digits) {
    std::array<char, 32> text;
    char* const end = write_decimal(text.data(), text.data() + text.size(), value,
                                    std::chars_format::general, digits);
    return {text.data(), end};
}

}  // namespace

ValueClasses::ValueClasses(const std::vector<double>& octaves, const ValueWords& words)
    : width_(kFinestClass) {
    const auto [least, most] = std::minmax_element(octaves.begin(), octaves.end());
    // The finest classes that cover the range.
    while (*most - *least > width_ * (kValueClasses - 1)) width_ *= 2;
    lowest_ = static_cast<int>(std::floor(*least / width_));
    const int last = of(*most);
    std::vector<int> count(static_cast<std::size_t>(last) + 1, 0);
    for (const double octave : octaves) ++count[of(octave)];
    for (int k = 0; k <= last; ++k) {
        const auto bound = [&](int c) {
            return rounded(std::exp2((lowest_ + c) * width_), words.digits);
        };
        classes_.push_back({.colour = value_colour(last == 0 ? 1 : double(k) / last),
                            .name = words.name + "_" + std::to_string(k),
                            .label = bound(k) + " to " + bound(k + 1) + words.unit + ": " +
                                     std::to_string(count[k])});
    }
}

int ValueClasses::of(double octave) const {
    return static_cast<int>(std::floor(octave / width_)) - lowest_;
}

}  // namespace pcvt
