#include "mesher/portable/portable_functions.hpp"

#include <cmath>
#include <limits>
#include <numbers>

namespace pcvt {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// x = 2^exponent (1 + z) / (1 - z), with sqrt(1/2) <= (1 + z) / (1 - z) < sqrt(2).
struct SplitLogarithm {
    int exponent = 0;
    double artanh = 0;
};

/// @param x  positive and finite.
SplitLogarithm split_logarithm(double x) {
    SplitLogarithm split;
    double m = std::frexp(x, &split.exponent);
    if (m < std::numbers::sqrt2 / 2) {
        m *= 2;
        --split.exponent;
    }
    const double z = (m - 1) / (m + 1);
    double sum = 0;
    for (int n = 23; n > 0; n -= 2) sum = 1.0 / n + sum * z * z;
    split.artanh = z * sum;
    return split;
}

/// Returns exponent + artanh(z) * `per_artanh`, times `per_exponent`.
double logarithm(double x, double per_exponent, double per_artanh) {
    if (x == 0) return -kInfinity;
    if (!(x > 0)) return kNan;
    if (x == kInfinity) return kInfinity;
    const SplitLogarithm split = split_logarithm(x);
    return split.exponent * per_exponent + split.artanh * per_artanh;
}

}  // namespace

double portable_exp(double x) {
    constexpr double kLargest = 710;
    constexpr double kSmallest = -746;
    if (x > kLargest) return kInfinity;
    if (x < kSmallest) return 0;
    if (std::isnan(x)) return x;
    // x = k ln 2 + r with |r| <= ln 2 / 2; the two parts of ln 2 keep r accurate.
    constexpr double kLn2High = 0x1.62e42fefa0000p-1;
    constexpr double kLn2Low = 0x1.cf79abc9e3b39p-40;
    const double k = std::floor(x / std::numbers::ln2 + 0.5);
    const double r = (x - k * kLn2High) - k * kLn2Low;
    double sum = 1;
    for (int n = 14; n > 0; --n) sum = 1 + sum * r / n;
    return std::ldexp(sum, static_cast<int>(k));
}

double portable_log(double x) { return logarithm(x, std::numbers::ln2, 2); }

double portable_log2(double x) { return logarithm(x, 1, 2 / std::numbers::ln2); }

double portable_log10(double x) {
    return logarithm(x, std::numbers::ln2 / std::numbers::ln10, 2 / std::numbers::ln10);
}

double portable_cbrt(double x) {
    if (x == 0 || !std::isfinite(x)) return x;
    // |x| = 8^k m with 1/8 <= m < 1.
    int exponent = 0;
    double m = std::frexp(std::abs(x), &exponent);
    const int k = exponent > 0 ? (exponent + 2) / 3 : exponent / 3;
    m = std::ldexp(m, exponent - 3 * k);
    // Five steps of Newton's method from a chord with an error below 0.06.
    double root = 0.45 + 0.58 * m;
    for (int step = 0; step < 5; ++step) root -= (root * root * root - m) / (3 * root * root);
    return std::copysign(std::ldexp(root, k), x);
}

}  // namespace pcvt
