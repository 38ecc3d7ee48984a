#pragma once

#include <limits>

#include "mesher/formula/number_parts.hpp"

namespace pcvt {

// The exponential function and logarithms of one number without branches, for loops that the
// compiler vectorises (block_exponentials.cpp has their public form). The polynomials interpolate
// the named functions at the Chebyshev nodes of the named intervals; their relative errors are
// below 2^-57.
//
// Example usage:
//
//     const double e = exponential({x, 0}, 0);         // exp(x)
//     const double l = natural_logarithm(x, 0, 0);     // log(x)

inline constexpr double kInfiniteNumber = std::numeric_limits<double>::infinity();
inline constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();

/// ln 2 in two parts: products of the first with exponents are exact.
inline constexpr double kLn2High = 0x1.62e42fefa3800p-1;
inline constexpr double kLn2Low = 0x1.ef35793c76730p-45;
inline constexpr double kPerLn2 = 0x1.71547652b82fep+0;

/// (exp(r) - 1 - r - r^2 / 2) / r^3 for |r| <= ln 2 / 2.
inline constexpr std::array kExponentialTail{
    0x1.5555555555556p-3,  0x1.5555555555555p-5,  0x1.11111111109b4p-7,  0x1.6c16c16c167e1p-10,
    0x1.a01a01a7c3d59p-13, 0x1.a01a01a47adc4p-16, 0x1.71de0daf7a6ccp-19, 0x1.27e4e1f5246c7p-22,
    0x1.af38a71a18cb9p-26, 0x1.1f66de051eb02p-29};
/// (2 artanh(s) - 2 s) / s^3 in z = s^2, for sqrt(1/2) <= (1 + s) / (1 - s) < sqrt(2).
inline constexpr std::array kLogarithmTail{
    0x1.5555555555555p-1, 0x1.9999999999a38p-2, 0x1.2492492476c8bp-2, 0x1.c71c720160332p-3,
    0x1.745cf90196560p-3, 0x1.3b1c35fbecd93p-3, 0x1.0fbe84f5caccap-3, 0x1.0c044ccf380aap-3};

/// exp(x.high + x.low) 2^-k, from 0.7 to 1.5, with an error of at most 0.6 units in the last place.
/// @param k  the whole number nearest to x.high / ln 2.
PCVT_IN_LANES double exponential_of_rest(NumberPair x, double k) {
    // x = k ln 2 + r with |r| <= ln 2 / 2.
    const double far = x.high - k * kLn2High;
    const double shift = k * kLn2Low - x.low;
    const double r = far - shift;
    const double low = (far - r) - shift;
    // Sum the series so that only the last addition rounds in the last place.
    const auto [sum, error] = exact_sum_of_ordered(1, r);
    const double rest = r * r * (0.5 + r * polynomial(r, kExponentialTail));
    return sum + (rest + (error + low));
}

/// exp(x.high + x.low) 2^power.
/// @param x  |x.high| <= 760 or NaN; |x.low| <= 2^-40 times |x.high|.
PCVT_IN_LANES double exponential(NumberPair x, double power) {
    const double k = nearest_whole(x.high * kPerLn2);
    return times_power_of_two(exponential_of_rest(x, k), k + power);
}

/// Brings x into the range of exponential(), beyond which its value is 0 or infinite.
PCVT_IN_LANES double in_exponential_range(double x) {
    constexpr double kBound = 750;
    const double below = x > kBound ? kBound : x;
    return below < -kBound ? -kBound : below;
}

/// x = 2^exponent m with sqrt(1/2) <= m < sqrt(2).
struct SplitNumber {
    double exponent;
    double m;
};

inline constexpr double kLeastNormal = 0x1p-1022;

/// @param x      positive, finite and at least kLeastNormal.
/// @param shift  of the exponent in the bits of x.
PCVT_IN_LANES SplitNumber split_normal_number(double x, double shift = 1023) {
    constexpr std::uint64_t kRootOfHalf = 0x3fe6a09e667f3bcd;
    constexpr double kWholeFromBits = 0x1p52;
    // The exponent grows by 1 where the digits are at least those of sqrt(1/2).
    const std::uint64_t bits = bits_of(x) + (bits_of(1.0) - kRootOfHalf);
    const double exponent = from_bits((bits >> 52) | bits_of(kWholeFromBits)) - kWholeFromBits;
    return {exponent - shift, from_bits((bits & 0xfffffffffffffull) + kRootOfHalf)};
}

/// @param x  positive and finite; other numbers have no defined result.
PCVT_IN_LANES SplitNumber split_number(double x) {
    const double shift = x < kLeastNormal ? 1023 + 54 : 1023;
    return split_normal_number(x < kLeastNormal ? x * 0x1p54 : x, shift);
}

/// log(x) replaced where x is not positive and finite.
PCVT_IN_LANES double logarithm_or_limit(double x, double log) {
    const double not_positive = x == 0 ? -kInfiniteNumber : kNotANumber;
    const double limit = x == kInfiniteNumber ? kInfiniteNumber : log;
    return x > 0 ? limit : not_positive;
}

/// log(x (1 + change)) + power ln 2, for |change| <= 2^-50.
PCVT_IN_LANES double natural_logarithm(double x, double change, double power) {
    const auto [exponent, m] = split_number(x);
    const double k = exponent + power;
    const double f = m - 1;
    const double s = f / (2 + f);
    const double z = s * s;
    const double half_square = 0.5 * f * f;
    const double rest = s * (half_square + z * polynomial(z, kLogarithmTail));
    const double log = k * kLn2High - ((half_square - (rest + (k * kLn2Low + change))) - f);
    return logarithm_or_limit(x, log);
}

}  // namespace pcvt
