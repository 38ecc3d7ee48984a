#include "io/pictures/plot_ticks.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "mesher/portable/decimal_text.hpp"

namespace pcvt {
namespace {

/// The approximate number of ticks of a linear axis.
constexpr int kWantedTicks = 6;
constexpr std::size_t kFewestTicks = 3;
/// Relative rounding errors of this size do not remove a tick from its axis.
constexpr double kTickRounding = 1e-9;

/// Returns the step of 1, 2 or 5 times a power of ten that is nearest, by ratio, to the desired
/// one.
double nice_step(double range) {
    const double rough = range / kWantedTicks;
    const double decade = std::pow(10.0, std::floor(std::log10(rough)));
    const double digit = rough / decade;
    // The bounds are the geometric means of neighbouring steps.
    if (digit < std::sqrt(2)) return decade;
    if (digit < std::sqrt(10)) return 2 * decade;
    if (digit < std::sqrt(50)) return 5 * decade;
    return 10 * decade;
}

std::vector<double> linear_ticks(double low, double high) {
    const double step = nice_step(high - low);
    std::vector<double> ticks;
    const double air = kTickRounding * (high - low);
    for (double k = std::ceil((low - air) / step); k * step <= high + air; ++k) {
        ticks.push_back(k * step);
    }
    return ticks;
}

std::vector<double> digit_ticks(double low, double high, const std::vector<int>& digits) {
    std::vector<double> ticks;
    for (int k = static_cast<int>(std::floor(std::log10(low)));
         k <= static_cast<int>(std::ceil(std::log10(high))); ++k) {
        for (const int digit : digits) {
            const double tick = digit * std::pow(10.0, k);
            if (tick >= low * (1 - kTickRounding) && tick <= high * (1 + kTickRounding)) {
                ticks.push_back(tick);
            }
        }
    }
    return ticks;
}

std::string superscript(int exponent) {
    static const std::array<const char*, 10> kDigits{"⁰", "¹", "²", "³", "⁴",
                                                     "⁵", "⁶", "⁷", "⁸", "⁹"};
    std::string text = exponent < 0 ? "⁻" : "";
    for (const char digit : std::to_string(std::abs(exponent))) text += kDigits[digit - '0'];
    return text;
}

/// Returns `value` with `digits` decimals.
std::string fixed(double value, int digits) {
    std::array<char, 400> text{};
    char* const end =
        write_decimal(text.begin(), text.end(), value, std::chars_format::fixed, digits);
    return {text.begin(), end};
}

int exponent_of(double value) {
    return value == 0 ? 0
                      : static_cast<int>(std::floor(std::log10(std::abs(value)) + kTickRounding));
}

TickLabels linear_labels(const std::vector<double>& ticks) {
    TickLabels labels;
    double largest = 0;
    for (const double tick : ticks) largest = std::max(largest, std::abs(tick));
    int exponent = exponent_of(largest);
    if (exponent >= -2 && exponent <= 4) exponent = 0;
    if (exponent != 0) labels.factor = "× 10" + superscript(exponent);
    const double unit = std::pow(10.0, exponent);
    const double step = ticks.size() > 1 ? (ticks[1] - ticks[0]) / unit : 1;
    for (const double tick : ticks) {
        labels.texts.push_back(fixed(tick / unit + 0.0, std::max(0, -exponent_of(step))));
    }
    return labels;
}

std::string logarithmic_label(double tick, bool as_power) {
    const int exponent = exponent_of(tick);
    if (!as_power) return fixed(tick, std::max(0, -exponent));
    const long digit = std::lround(tick / std::pow(10.0, exponent));
    return (digit == 1 ? "" : std::to_string(digit) + "·") + "10" + superscript(exponent);
}

TickLabels logarithmic_labels(const std::vector<double>& ticks) {
    TickLabels labels;
    const bool as_power = ticks.front() < 1e-2 || ticks.back() > 9999;
    for (const double tick : ticks) labels.texts.push_back(logarithmic_label(tick, as_power));
    return labels;
}

}  // namespace

std::vector<double> axis_ticks(double low, double high, bool logarithmic) {
    if (!logarithmic) return linear_ticks(low, high);
    for (const std::vector<int>& digits :
         {std::vector<int>{1}, {1, 2, 5}, {1, 2, 3, 4, 5, 6, 7, 8, 9}}) {
        std::vector<double> ticks = digit_ticks(low, high, digits);
        if (ticks.size() >= kFewestTicks) return ticks;
    }
    return linear_ticks(low, high);
}

TickLabels tick_labels(const std::vector<double>& ticks, bool logarithmic) {
    return logarithmic && ticks.size() > 1 ? logarithmic_labels(ticks) : linear_labels(ticks);
}

}  // namespace pcvt
