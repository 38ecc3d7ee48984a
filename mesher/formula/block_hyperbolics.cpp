#include "mesher/formula/block_hyperbolics.hpp"

#include <cmath>

#include "mesher/base/target_clones.hpp"
#include "mesher/formula/exponentials_in_lanes.hpp"

namespace pcvt {
namespace {

// Below these sizes, series replace the formulas, which cancel there. Each series interpolates
// (f(x) - x) / x^3 in z = x^2 at Chebyshev nodes, with an error below 2^-57 of f.
constexpr double kSmallSinh = 1;
constexpr std::array kSinhTail{0x1.5555555555555p-3,  0x1.1111111111111p-7,  0x1.a01a01a01a001p-13,
                               0x1.71de3a556f96cp-19, 0x1.ae6456792a77fp-26, 0x1.612467ccb2260p-33,
                               0x1.ae777c36fd5b6p-41, 0x1.99f0806c2628dp-49};
constexpr double kSmallTanh = 0.6;
constexpr std::array kTanhTail{
    -0x1.5555555555555p-2,  0x1.11111111110e3p-3,  -0x1.ba1ba1ba15b29p-5,  0x1.664f488056b96p-6,
    -0x1.226e34dc136f6p-7,  0x1.d6d3b05a99f57p-9,  -0x1.7da0cedf6d09bp-10, 0x1.3535559875683p-11,
    -0x1.f30583c23502ap-13, 0x1.876e3a6430a18p-14, -0x1.0d297a9d86a2cp-15, 0x1.d15602ab6f13ap-18};
constexpr double kSmallInverse = 0.5;
constexpr std::array kArsinhTail{
    -0x1.5555555555555p-3, 0x1.3333333332f5fp-4, -0x1.6db6db6d5b365p-5, 0x1.f1c71c3bee026p-6,
    -0x1.6e8b9ab4638efp-6, 0x1.1c4e072f36dc7p-6, -0x1.c983b8d12e853p-7, 0x1.79b0dbdcdfc75p-7,
    -0x1.3a4aeece7e69cp-7, 0x1.f38921b605d54p-8, -0x1.4733e5158e0e1p-8, 0x1.ee3fd77d44d42p-10};
constexpr std::array kArtanhTail{0x1.5555555555555p-2,  0x1.9999999999ad1p-3, 0x1.249249247e911p-3,
                                 0x1.c71c71d6cc5d1p-4,  0x1.745d1406b992ep-4, 0x1.3b1417e6e07dfp-4,
                                 0x1.1108e26d64a6dp-4,  0x1.e2c342108eb1fp-5, 0x1.a6c53053bf30cp-5,
                                 0x1.bdcd3cefa72cep-5,  0x1.92cc88a36f708p-7, 0x1.15aa7698edf42p-3,
                                 -0x1.27f230f3831a3p-3, 0x1.b016cba23eee4p-3};
/// (arcosh(1 + t) / sqrt(2 t) - 1) / t for 0 <= t <= 1/2.
constexpr std::array kArcoshTail{
    -0x1.5555555555555p-4,  0x1.3333333332f5fp-6,  -0x1.6db6db6d5b365p-8,  0x1.f1c71c3bee026p-10,
    -0x1.6e8b9ab4638efp-11, 0x1.1c4e072f36dc7p-12, -0x1.c983b8d12e853p-14, 0x1.79b0dbdcdfc75p-15,
    -0x1.3a4aeece7e69cp-16, 0x1.f38921b605d54p-18, -0x1.4733e5158e0e1p-19, 0x1.ee3fd77d44d42p-22};

template <std::size_t N>
PCVT_IN_LANES double odd_series(double x, const std::array<double, N>& tail) {
    const double z = x * x;
    return with_sign_of(x, x + x * (z * polynomial(z, tail)));
}

/// exp(|x|) / 2.
PCVT_IN_LANES double half_exponential(double x) {
    return exponential({in_exponential_range(magnitude_of(x)), 0}, -1);
}

PCVT_IN_LANES double sinh_of(double x) {
    const double half = half_exponential(x);
    const double large = with_sign_of(x, half - 0.25 / half);
    return magnitude_of(x) < kSmallSinh ? odd_series(x, kSinhTail) : large;
}

PCVT_IN_LANES double cosh_of(double x) {
    const double half = half_exponential(x);
    return half + 0.25 / half;
}

PCVT_IN_LANES double tanh_of(double x) {
    const double half = half_exponential(2 * x);
    const double large = with_sign_of(x, 1 - 1 / (half + 0.5));
    return magnitude_of(x) < kSmallTanh ? odd_series(x, kTanhTail) : large;
}

/// ln(x + sqrt(x^2 + one)).
/// @param x    at least 1/2.
/// @param one  1 or -1.
PCVT_IN_LANES double logarithm_of_both(double x, double one) {
    // x^2 + one = square + square_low.
    const double lead = leading_half(x);
    const NumberPair sum = exact_sum(lead * lead, one);
    const auto [square, square_low] =
        exact_sum_of_ordered(sum.high, sum.low + (x - lead) * (x + lead));
    // Its root is root + root_low.
    const double root = std::sqrt(square);
    const double root_lead = leading_half(root);
    const double rest = (square - root_lead * root_lead) - (root - root_lead) * (root + root_lead);
    const double root_low = (rest + square_low) * (0.5 / root);
    const NumberPair both = exact_sum(root, x);
    const double change = (both.low + root_low) / both.high;
    // From here on, the root equals x up to rounding.
    constexpr double kLarge = 0x1p27;
    const bool is_large = x > kLarge;
    return natural_logarithm(is_large ? x : both.high, is_large ? 0 : change, is_large ? 1 : 0);
}

PCVT_IN_LANES double asinh_of(double x) {
    const double size = magnitude_of(x);
    const bool is_small = size < kSmallInverse;
    const double large = with_sign_of(x, logarithm_of_both(size, 1));
    return is_small ? odd_series(x, kArsinhTail) : large;
}

PCVT_IN_LANES double acosh_of(double x) {
    const double t = x - 1;
    const double root = std::sqrt(2 * t);
    const double near_1 = root + root * (t * polynomial(t, kArcoshTail));
    const double large = logarithm_of_both(x, -1);
    return t < kSmallInverse ? near_1 : large;
}

PCVT_IN_LANES double atanh_of(double x) {
    const double size = magnitude_of(x);
    const auto [sum, error] = exact_sum_of_ordered(1, size);
    const double large = 0.5 * natural_logarithm(sum / (1 - size), error / sum, 0);
    return size < kSmallInverse ? odd_series(x, kArtanhTail) : with_sign_of(x, large);
}

}  // namespace

PCVT_TARGET_CLONES void block_sinh(const double* __restrict x, double* __restrict y, int n) {
    for (int k = 0; k < whole_lanes(n); ++k) y[k] = sinh_of(x[k]);
}

PCVT_TARGET_CLONES void block_cosh(const double* __restrict x, double* __restrict y, int n) {
    for (int k = 0; k < whole_lanes(n); ++k) y[k] = cosh_of(x[k]);
}

PCVT_TARGET_CLONES void block_tanh(const double* __restrict x, double* __restrict y, int n) {
    for (int k = 0; k < whole_lanes(n); ++k) y[k] = tanh_of(x[k]);
}

PCVT_TARGET_CLONES void block_asinh(const double* __restrict x, double* __restrict y, int n) {
    for (int k = 0; k < whole_lanes(n); ++k) y[k] = asinh_of(x[k]);
}

PCVT_TARGET_CLONES void block_acosh(const double* __restrict x, double* __restrict y, int n) {
    for (int k = 0; k < whole_lanes(n); ++k) y[k] = acosh_of(x[k]);
}

PCVT_TARGET_CLONES void block_atanh(const double* __restrict x, double* __restrict y, int n) {
    for (int k = 0; k < whole_lanes(n); ++k) y[k] = atanh_of(x[k]);
}

}  // namespace pcvt
