#include "mesher/formula/block_exponentials.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "mesher/base/target_clones.hpp"
#include "mesher/formula/exponentials_in_lanes.hpp"

namespace pcvt {
namespace {

/// (artanh(s) / s - 1 - s^2 / 3) / s^4 in z = s^2, on the interval of kLogarithmTail.
constexpr std::array kPowerTail{0x1.999999999999ap-3, 0x1.2492492492521p-3, 0x1.c71c71c6eaa18p-4,
                                0x1.745d177a95904p-4, 0x1.3b1395d249ed7p-4, 0x1.1118c7da4e209p-4,
                                0x1.df7ccb122450bp-5, 0x1.e02e59475f3c5p-5};
/// m^(-1/3) for 2^-1.5 <= m <= 2^1.5, with a relative error of 2^-8.
constexpr std::array kCubeRootStart{0x1.faa5766bc7719p+0, -0x1.1b902cbcb23a9p+1,
                                    0x1.0379efc457224p+1, -0x1.08cfbe0bb816dp+0,
                                    0x1.12dda4437fda6p-2, -0x1.c44bccf65bb82p-6};

/// So many numbers pass through the loops of a function one after the other.
constexpr int kNumbersAtOnce = 64;

PCVT_IN_LANES double exponential_of(double x) {
    return exponential({in_exponential_range(x), 0}, 0);
}

/// The same for |x| <= kNormalExponent, where the result needs no rounding to a power of 2.
constexpr double kNormalExponent = 708;
PCVT_IN_LANES double normal_exponential(NumberPair x) {
    const double turns = x.high * kPerLn2 + kToWhole;
    const double sum = exponential_of_rest(x, turns - kToWhole);
    return from_bits(bits_of(sum) + (bits_of(turns) << 52));
}
/// Has the sign bit for |x| > kNormalExponent and NaN.
PCVT_IN_LANES std::uint64_t beyond_normal_exponents(double x) {
    return bits_of(kNormalExponent) - bits_of(magnitude_of(x));
}

/// A factor in two parts, the first of which has 26 bits and the second the rest of the factor.
struct LogarithmBase {
    /// The logarithm of 2 to this base; the first part has 42 bits.
    double of_2_high;
    double of_2_low;
    /// 1 / ln(base).
    double scale_high;
    double scale_low;
};
constexpr LogarithmBase kBase2{1, 0, 0x1.7154760000000p+0, 0x1.4ae0bf85ddf44p-26};
constexpr LogarithmBase kBase10{0x1.34413509f7800p-2, 0x1.fef311f12b358p-46, 0x1.bcb7b10000000p-2,
                                0x1.49b9438ca9aaep-28};

/// The logarithm to a base.
PCVT_IN_LANES double logarithm_of(double x, const LogarithmBase& base) {
    const auto [k, m] = split_number(x);
    const double f = m - 1;
    const double s = f / (2 + f);
    const double z = s * s;
    const double half_square = 0.5 * f * f;
    const double rest = s * (half_square + z * polynomial(z, kLogarithmTail));
    // ln(m) = high + low, where high has 26 bits.
    const double high = leading_half(f - half_square);
    const double low = ((f - high) - half_square) + rest;
    const double small =
        k * base.of_2_low + (low * base.scale_high + (low + high) * base.scale_low);
    const auto [sum, error] = exact_sum_of_ordered(k * base.of_2_high, high * base.scale_high);
    return logarithm_or_limit(x, sum + (error + small));
}

/// The natural logarithm with some 66 bits.
PCVT_IN_LANES NumberPair accurate_logarithm(SplitNumber x) {
    const auto [k, m] = x;
    // s = (m - 1) / (m + 1) = s_high + s_low, where s_high has 26 bits.
    const double f = m - 1;
    const double sum = m + 1;
    const double inverse = 1 / sum;
    const double s_high = leading_half(f * inverse);
    const double sum_high = leading_half(sum);
    const double sum_low = m - (sum_high - 1);
    const double s_low = ((f - s_high * sum_high) - s_high * sum_low) * inverse;
    // z = s^2 = z_high + z_low.
    const double square = s_high * s_high;
    const double z_high = leading_half(square);
    const double z_low = (square - z_high) + (2 * s_high + s_low) * s_low;
    const double z = z_high + z_low;
    // c = 1 / 3 + z / 5 + ... = c_high + c_low.
    constexpr double kThird = 0x1.5555555555555p-2;
    constexpr double kThirdLow = 0x1.5555555555555p-56;
    const double tail = z * polynomial(z, kPowerTail);
    const double c_high = leading_half(kThird + tail);
    const double c_low = ((kThird - c_high) + tail) + kThirdLow;
    // t = z c = t_high + t_low; artanh(s) = s + s t.
    const double product = z_high * c_high;
    const double t_high = leading_half(product);
    const double t_low = (product - t_high) + (z_high * c_low + z_low * (c_high + c_low));
    const double u_high = s_high * t_high;
    const double u_low = s_high * t_low + s_low * (t_high + t_low);
    const auto [arc, arc_error] = exact_sum_of_ordered(s_high, u_high);
    const double arc_low = arc_error + (s_low + u_low);
    const auto [log, log_error] = exact_sum_of_ordered(k * kLn2High, 2 * arc);
    return {log, log_error + (2 * arc_low + k * kLn2Low)};
}

PCVT_IN_LANES NumberPair product(NumberPair log, double y) {
    const double log_lead = leading_half(log.high);
    const double log_rest = (log.high - log_lead) + log.low;
    const double y_lead = leading_half(y);
    return exact_sum_of_ordered(y_lead * log_lead, (y - y_lead) * log_lead + y * log_rest);
}

/// y ln(x) for x >= 0, in the range of exponential().
PCVT_IN_LANES NumberPair exponent_of_power(double x, double y) {
    const NumberPair log = accurate_logarithm(split_number(x));
    const auto [high, low] = product(log, y);
    const double whole = y * logarithm_or_limit(x, log.high + log.low);
    const bool is_moderate = magnitude_of(whole) < 750;
    return {is_moderate ? high : in_exponential_range(whole), is_moderate ? low : 0};
}

/// x^y.
/// @param power  that of |x|.
PCVT_IN_LANES double power_with_limits(double x, double y, double power) {
    // Bases below zero have powers with whole exponents only.
    const double half = y * 0.5;
    const bool is_whole = nearest_whole_of_any(y) == y;
    const bool is_odd = is_whole & (nearest_whole_of_any(half) != half);
    const double with_sign = is_odd ? with_sign_of(x, power) : power;
    const bool is_defined = is_whole | (x >= 0) | (x == -kInfiniteNumber);
    const double result = is_defined ? with_sign : kNotANumber;
    const double numeric = ((x == x) & (y == y)) ? result : kNotANumber;
    const bool is_one = (y == 0) | (x == 1) | ((x == -1) & (magnitude_of(y) == kInfiniteNumber));
    return is_one ? 1 : numeric;
}

/// Has the sign bit for all but positive, finite, normal numbers.
PCVT_IN_LANES std::uint64_t beyond_normal_bases(double x) {
    constexpr std::uint64_t kLargest = 0x7fefffffffffffff;
    const std::uint64_t bits = bits_of(x);
    return bits | (bits - bits_of(kLeastNormal)) | (kLargest - bits);
}

PCVT_IN_LANES double cube_root_of(double x) {
    // |x| = 8^k m.
    const double size = magnitude_of(x);
    const auto [exponent, near_1] = split_number(size);
    const double k = nearest_whole(exponent * (1.0 / 3));
    const double m = near_1 * power_of_two(exponent - 3 * k);
    // y = m^(-1/3) with 22 bits.
    const double start = polynomial(m, kCubeRootStart);
    const double gap = 1 - m * (start * start * start);
    const double y = start * (1 + gap * (1.0 / 3 + gap * (2.0 / 9)));
    // One step of Halley's method from a root of 26 bits, whose cube is exact in two parts.
    const double root = leading_half(m * (y * y));
    const double square = root * root;
    const double square_high = leading_half(square);
    const double rest = (m - square_high * root) - (square - square_high) * root;
    const double better = root + root * rest / (3 * m - 2 * rest);
    const bool is_itself = !(size < kInfiniteNumber) | (size == 0);
    return is_itself ? x : with_sign_of(x, better * power_of_two(k));
}

// In both functions of powers, two short loops overlap more of their operations than a long one.

/// Writes n powers, at most kNumbersAtOnce, unless a base is not a positive normal number or a
/// power may not be one; returns whether it has. The numbers are those of all_powers.
PCVT_TARGET_CLONES bool normal_powers(const double* __restrict a, const double* __restrict b,
                                      double* __restrict y, int n) {
    std::uint64_t any_other = 0;
    for (int k = 0; k < whole_lanes(n); ++k) any_other |= beyond_normal_bases(a[k]);
    if ((any_other & kSignBit) != 0) return false;
    double high[kNumbersAtOnce];
    double low[kNumbersAtOnce];
    for (int k = 0; k < whole_lanes(n); ++k) {
        const NumberPair log = accurate_logarithm(split_normal_number(a[k]));
        const NumberPair exponent = product(log, b[k]);
        high[k] = exponent.high;
        low[k] = exponent.low;
        any_other |= beyond_normal_exponents(exponent.high);
    }
    if ((any_other & kSignBit) != 0) return false;
    for (int k = 0; k < whole_lanes(n); ++k) y[k] = normal_exponential({high[k], low[k]});
    return true;
}

/// Writes n powers, at most kNumbersAtOnce.
PCVT_TARGET_CLONES void all_powers(const double* __restrict a, const double* __restrict b,
                                   double* __restrict y, int n) {
    double high[kNumbersAtOnce];
    double low[kNumbersAtOnce];
    for (int k = 0; k < whole_lanes(n); ++k) {
        const NumberPair exponent = exponent_of_power(magnitude_of(a[k]), b[k]);
        high[k] = exponent.high;
        low[k] = exponent.low;
    }
    for (int k = 0; k < whole_lanes(n); ++k) {
        y[k] = power_with_limits(a[k], b[k], exponential({high[k], low[k]}, 0));
    }
}

}  // namespace

PCVT_TARGET_CLONES void block_exp(const double* __restrict x, double* __restrict y, int n) {
    for (int from = 0; from < n; from += kNumbersAtOnce) {
        const int n_here = std::min(whole_lanes(n - from), kNumbersAtOnce);
        std::uint64_t any_other = 0;
        for (int k = 0; k < n_here; ++k) {
            y[from + k] = normal_exponential({x[from + k], 0});
            any_other |= beyond_normal_exponents(x[from + k]);
        }
        if ((any_other & kSignBit) == 0) continue;
        for (int k = 0; k < n_here; ++k) y[from + k] = exponential_of(x[from + k]);
    }
}

PCVT_TARGET_CLONES void block_log(const double* __restrict x, double* __restrict y, int n) {
    for (int k = 0; k < whole_lanes(n); ++k) y[k] = natural_logarithm(x[k], 0, 0);
}

PCVT_TARGET_CLONES void block_log2(const double* __restrict x, double* __restrict y, int n) {
    for (int k = 0; k < whole_lanes(n); ++k) y[k] = logarithm_of(x[k], kBase2);
}

PCVT_TARGET_CLONES void block_log10(const double* __restrict x, double* __restrict y, int n) {
    for (int k = 0; k < whole_lanes(n); ++k) y[k] = logarithm_of(x[k], kBase10);
}

void block_pow(const double* __restrict a, const double* __restrict b, double* __restrict y,
               int n) {
    for (int from = 0; from < n; from += kNumbersAtOnce) {
        const int n_here = std::min(n - from, kNumbersAtOnce);
        if (!normal_powers(a + from, b + from, y + from, n_here)) {
            all_powers(a + from, b + from, y + from, n_here);
        }
    }
}

PCVT_TARGET_CLONES void block_sqrt(const double* __restrict x, double* __restrict y, int n) {
    for (int k = 0; k < whole_lanes(n); ++k) y[k] = std::sqrt(x[k]);
}

PCVT_TARGET_CLONES void block_cbrt(const double* __restrict x, double* __restrict y, int n) {
    for (int k = 0; k < whole_lanes(n); ++k) y[k] = cube_root_of(x[k]);
}

}  // namespace pcvt
