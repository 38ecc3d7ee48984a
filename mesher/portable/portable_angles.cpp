#include "mesher/portable/portable_angles.hpp"

#include <cmath>
#include <limits>
#include <numbers>

namespace pcvt {
namespace {

/// Returns the values at k pi / 2 + x.
/// @param x  |x| <= pi / 4, up to rounding.
/// @param k  at least -8.
CosSin after_quarter_turns(int k, double x) {
    double cos = 1;
    double sin = 1;
    for (int n = 18; n > 0; n -= 2) {
        cos = 1 - cos * x * x / (n * (n - 1));
        sin = 1 - sin * x * x / (n * (n + 1));
    }
    sin *= x;
    switch ((k + 8) % 4) {
        case 0:
            return {cos, sin};
        case 1:
            return {-sin, cos};
        case 2:
            return {-cos, -sin};
        default:
            return {sin, -cos};
    }
}

/// Returns the arc tangent of t in [0, 1].
double small_arc(double t) {
    // tan(angle) = t; three halvings of the angle leave a short series.
    for (int k = 0; k < 3; ++k) t = t / (1 + std::sqrt(1 + t * t));
    double sum = 0;
    for (int n = 19; n > 0; n -= 2) sum = 1.0 / n - sum * t * t;
    return 8 * t * sum;
}

/// Returns the arc tangent of t >= 0.
double arc(double t) { return t > 1 ? std::numbers::pi / 2 - small_arc(1 / t) : small_arc(t); }

}  // namespace

CosSin cos_sin_of_degrees(double degrees) {
    // degrees = 90 k + r with |r| <= 45; both steps are exact.
    const double turn = std::fmod(degrees, 360);
    const double k = std::floor(turn / 90 + 0.5);
    return after_quarter_turns(static_cast<int>(k), (turn - 90 * k) * (std::numbers::pi / 180));
}

double degrees_of_cosine(double u) {
    // tan(angle / 2) = sqrt(u / (1 - u)).
    return 2 * arc(std::sqrt(u / (1 - u))) * (180 / std::numbers::pi);
}

CosSin cos_sin(double radians) {
    if (!std::isfinite(radians)) {
        constexpr double kUndefined = std::numeric_limits<double>::quiet_NaN();
        return {kUndefined, kUndefined};
    }
    constexpr double kLargest = 1e5;
    if (std::abs(radians) > kLargest) radians = std::fmod(radians, 2 * std::numbers::pi);
    // radians = k pi / 2 + r; the products of k with the first two of the three parts of pi / 2,
    // which have 33 bits each, are exact.
    constexpr double kHigh = 0x1.921fb544p+0;
    constexpr double kMiddle = 0x1.0b4611a6p-34;
    constexpr double kLow = 0x1.3198a2e037073p-69;
    const double k = std::floor(radians / (std::numbers::pi / 2) + 0.5);
    const double r = ((radians - k * kHigh) - k * kMiddle) - k * kLow;
    return after_quarter_turns(static_cast<int>(std::fmod(k, 4)), r);
}

double portable_sin(double radians) { return cos_sin(radians).sin; }

double portable_cos(double radians) { return cos_sin(radians).cos; }

double portable_tan(double radians) {
    const auto [cos, sin] = cos_sin(radians);
    return sin / cos;
}

double portable_acos(double cosine) {
    return portable_atan2(std::sqrt((1 - cosine) * (1 + cosine)), cosine);
}

double portable_atan2(double y, double x) {
    if (std::isnan(x) || std::isnan(y)) return x + y;
    const bool is_infinite = std::isinf(x) && std::isinf(y);
    const double tangent = is_infinite ? 1 : (y == 0 ? 0 : std::abs(y / x));
    const double angle = arc(tangent);
    return std::copysign(std::signbit(x) ? std::numbers::pi - angle : angle, y);
}

}  // namespace pcvt
