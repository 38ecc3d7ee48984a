#include "mesher/formula/block_angles.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mesher/base/target_clones.hpp"
#include "mesher/formula/huge_angle.hpp"
#include "mesher/formula/number_parts.hpp"

namespace pcvt {
namespace {

// Polynomials that interpolate the named functions in z = x^2 at Chebyshev nodes, with errors below
// 2^-57 of the function.

/// (sin(x) - x) / x^3 and (cos(x) - 1 + x^2 / 2) / x^4 for |x| <= pi / 4.
constexpr std::array kSineTail{
    -0x1.5555555555555p-3,  0x1.1111111111110p-7,  -0x1.a01a01a019937p-13, 0x1.71de3a54607fap-19,
    -0x1.ae6454129f078p-26, 0x1.61217eed1c04ap-33, -0x1.ab17c21adf462p-41};
constexpr std::array kCosineTail{0x1.5555555555555p-5,  -0x1.6c16c16c16967p-10,
                                 0x1.a01a019f4e9f4p-16, -0x1.27e4fa17c44e0p-22,
                                 0x1.1eeb68d2958ddp-29, -0x1.907d9316a965fp-37};
/// (arcsin(x) - x) / x^3 for |x| <= 1/2.
constexpr std::array kArcSineTail{0x1.5555555555555p-3,  0x1.3333333333388p-4, 0x1.6db6db6dac1e0p-5,
                                  0x1.f1c71c7a52ba3p-6,  0x1.6e8ba123e494cp-6, 0x1.1c4efce23019fp-6,
                                  0x1.c990ad3d8fdcap-7,  0x1.7b027ee1dd585p-7, 0x1.3b49de7121487p-7,
                                  0x1.31622469ce5adp-7,  0x1.8f193743418ffp-9, 0x1.406192d124629p-6,
                                  -0x1.3b416bb7d9257p-6, 0x1.e529c6fce9bb4p-6};
/// (arctan(x) - x) / x^3 for |x| <= 7/16.
constexpr std::array kArcTangentTail{
    -0x1.5555555555555p-2, 0x1.99999999998c5p-3, -0x1.24924924854fap-3, 0x1.c71c71bd2b24cp-4,
    -0x1.745d154c73072p-4, 0x1.3b1375cc8b183p-4, -0x1.110c9cca782dep-4, 0x1.e1707db025c52p-5,
    -0x1.ab59a4918c9bbp-5, 0x1.700141f9da66fp-5, -0x1.0f6229629ac10p-5, 0x1.e4142f4ea3d2cp-7};

constexpr NumberPair kHalfPi{0x1.921fb54442d18p+0, 0x1.1a62633145c07p-54};

/// Up to here, products of the numbers of quarter turns with the parts of pi / 2 are exact.
constexpr double kLargestAngle = 1e6;
/// So many angles are reduced at once.
constexpr int kAnglesAtOnce = 64;

/// Angles without their quarter turns.
struct ReducedAngles {
    double rest[kAnglesAtOnce];
    double rest_low[kAnglesAtOnce];
    std::uint64_t n_quarters[kAnglesAtOnce];
};

PCVT_IN_LANES ReducedAngle reduce_angle(double x) {
    constexpr double kTwoOverPi = 0x1.45f306dc9c883p-1;
    // pi / 2 in four parts, of which the first three have 33 bits.
    constexpr double kPart1 = 0x1.921fb54400000p+0;
    constexpr double kPart2 = 0x1.0b4611a600000p-34;
    constexpr double kPart3 = 0x1.3198a2e000000p-69;
    constexpr double kPart4 = 0x1.b839a252049c1p-104;
    const double turns = x * kTwoOverPi + kToWhole;
    const double k = turns - kToWhole;
    const NumberPair second = exact_sum(x - k * kPart1, -(k * kPart2));
    const NumberPair third = exact_sum(second.high, -(k * kPart3));
    const double low = (second.low + third.low) - k * kPart4;
    const double rest = third.high + low;
    return {{rest, (third.high - rest) + low}, bits_of(turns)};
}

/// Reduces the angles that are too large for reduce_angle.
[[gnu::noinline]] void reduce_huge(const double* x, int n, ReducedAngles& angles) {
    for (int k = 0; k < n; ++k) {
        if (std::abs(x[k]) <= kLargestAngle) continue;
        const ReducedAngle angle = reduce_huge_angle(x[k]);
        angles.rest[k] = angle.rest.high;
        angles.rest_low[k] = angle.rest.low;
        angles.n_quarters[k] = angle.n_quarters;
    }
}

/// @param n  a multiple of kLanes.
PCVT_IN_LANES void reduce_angles(const double* __restrict x, int n, ReducedAngles& angles) {
    std::uint64_t any_huge = 0;
    for (int k = 0; k < n; ++k) {
        const ReducedAngle angle = reduce_angle(x[k]);
        angles.rest[k] = angle.rest.high;
        angles.rest_low[k] = angle.rest.low;
        angles.n_quarters[k] = angle.n_quarters;
        any_huge |= bits_of(kLargestAngle - magnitude_of(x[k]));
    }
    if ((any_huge & kSignBit) != 0) reduce_huge(x, n, angles);
}

/// sin(x.high + x.low).
PCVT_IN_LANES NumberPair sine_of_rest(NumberPair x) {
    const double z = x.high * x.high;
    const double tail = x.high * (z * polynomial(z, kSineTail)) + x.low * (1 - 0.5 * z);
    return exact_sum_of_ordered(x.high, tail);
}

/// cos(x.high + x.low).
PCVT_IN_LANES NumberPair cosine_of_rest(NumberPair x) {
    const double z = x.high * x.high;
    const double half = 0.5 * z;
    const auto [lead, error] = exact_sum_of_ordered(1, -half);
    const double tail = error + (z * (z * polynomial(z, kCosineTail)) - x.high * x.low);
    return exact_sum_of_ordered(lead, tail);
}

/// The sine of an angle; the cosine is that of an angle with one quarter turn more.
PCVT_IN_LANES double sine_of(const ReducedAngles& angles, int k, std::uint64_t n_more) {
    const NumberPair rest{angles.rest[k], angles.rest_low[k]};
    const std::uint64_t n = angles.n_quarters[k] + n_more;
    const double size = choose_by_bit(n, cosine_of_rest(rest).high, sine_of_rest(rest).high);
    return from_bits(bits_of(size) ^ ((n << 62) & kSignBit));
}

PCVT_IN_LANES double tangent_of(const ReducedAngles& angles, int k) {
    const NumberPair rest{angles.rest[k], angles.rest_low[k]};
    const NumberPair sine = sine_of_rest(rest);
    const NumberPair cosine = cosine_of_rest(rest);
    // The tangent after a quarter turn is the negative inverse.
    const std::uint64_t n = angles.n_quarters[k];
    const NumberPair up{choose_by_bit(n, cosine.high, sine.high),
                        choose_by_bit(n, cosine.low, sine.low)};
    const NumberPair down{choose_by_bit(n, sine.high, cosine.high),
                          choose_by_bit(n, sine.low, cosine.low)};
    const double ratio = up.high / down.high;
    const double better = ratio + (up.low - ratio * down.low) / down.high;
    // Near zeros of the divisor, the correction has no defined value.
    const double tangent = magnitude_of(ratio) < 0x1p1000 ? better : ratio;
    return from_bits(bits_of(tangent) ^ ((n << 63) & kSignBit));
}

/// (arcsin(x) - x) / x, for z = x^2.
PCVT_IN_LANES double arc_sine_tail(double z) { return z * polynomial(z, kArcSineTail); }

/// Half of the arc cosine of 1 - 2 z, z <= 1/4, as a root of 26 bits and the rest.
PCVT_IN_LANES NumberPair half_arc(double z, double tail) {
    const double root = std::sqrt(z);
    const double lead = leading_half(root);
    const double sum = root + lead;
    const double rest = sum > 0 ? (z - lead * lead) / sum : 0;
    return {lead, rest + root * tail};
}

PCVT_IN_LANES double arc_sine_of(double x) {
    const double size = magnitude_of(x);
    const bool is_small = size < 0.5;
    const double z = is_small ? x * x : (1 - size) * 0.5;
    const double tail = arc_sine_tail(z);
    // arcsin(x) = pi / 2 - 2 arcsin(sqrt((1 - x) / 2)).
    const NumberPair arc = half_arc(z, tail);
    const double quarter = kHalfPi.high * 0.5;
    const double large = quarter - ((2 * arc.low - kHalfPi.low) - (quarter - 2 * arc.high));
    return is_small ? x + x * tail : with_sign_of(x, large);
}

PCVT_IN_LANES double arc_cosine_of(double x) {
    const double size = magnitude_of(x);
    const bool is_small = size < 0.5;
    const double z = is_small ? x * x : (1 - size) * 0.5;
    const double tail = arc_sine_tail(z);
    const NumberPair arc = half_arc(z, tail);
    const double small = kHalfPi.high - (x - (kHalfPi.low - x * tail));
    const double near_1 = 2 * (arc.high + arc.low);
    const double near_minus_1 = 2 * ((kHalfPi.high - arc.high) - (arc.low - kHalfPi.low));
    return is_small ? small : (x > 0 ? near_1 : near_minus_1);
}

/// The arc tangent of t >= 0, as the sum of two numbers.
PCVT_IN_LANES NumberPair arc_tangent_of_size(double t) {
    // arctan(t) = arctan(c) + arctan((t - c) / (1 + c t)) for c = 0, 1/2, 1, 3/2 and infinity.
    const bool is_0 = t < 7.0 / 16;
    const bool is_half = t < 11.0 / 16;
    const bool is_1 = t < 19.0 / 16;
    const bool is_finite = !(t > 39.0 / 16);
    const double c = is_0 ? 0 : is_half ? 0.5 : is_1 ? 1 : 1.5;
    const double high = is_0        ? 0
                        : is_half   ? 0x1.dac670561bb4fp-2
                        : is_1      ? kHalfPi.high / 2
                        : is_finite ? 0x1.f730bd281f69bp-1
                                    : kHalfPi.high;
    const double low = is_0        ? 0
                       : is_half   ? 0x1.a2b7f222f65e2p-56
                       : is_1      ? kHalfPi.low / 2
                       : is_finite ? 0x1.007887af0cbbdp-56
                                   : kHalfPi.low;
    const double up = is_finite ? t - c : -1;
    const double down = is_finite ? 1 + c * t : t;
    const double x = up / down;
    const double z = x * x;
    const double tail = x * (z * polynomial(z, kArcTangentTail));
    return {high, x + (tail + low)};
}

PCVT_IN_LANES double arc_tangent_of(double x) {
    const NumberPair arc = arc_tangent_of_size(magnitude_of(x));
    return with_sign_of(x, arc.high + arc.low);
}

/// The angle of the point (x, y).
PCVT_IN_LANES double angle_of(double y, double x) {
    const double high = magnitude_of(y);
    const double wide = magnitude_of(x);
    const bool both_infinite = (high == wide) & (high > 0x1.fffffffffffffp+1023);
    const double slope = high == 0 ? 0 : high / wide;
    const NumberPair arc = arc_tangent_of_size(both_infinite ? 1 : slope);
    const double right = arc.high + arc.low;
    const double left = (2 * kHalfPi.high - arc.high) - (arc.low - 2 * kHalfPi.low);
    const double angle = with_sign_of(y, choose_by_bit(bits_of(x) >> 63, left, right));
    return ((x == x) & (y == y)) ? angle : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

PCVT_TARGET_CLONES void block_sin(const double* __restrict x, double* __restrict y, int n) {
    ReducedAngles angles;
    for (int from = 0; from < n; from += kAnglesAtOnce) {
        const int n_here = std::min(whole_lanes(n - from), kAnglesAtOnce);
        reduce_angles(x + from, n_here, angles);
        for (int k = 0; k < n_here; ++k) {
            const double sine = sine_of(angles, k, 0);
            y[from + k] = x[from + k] == 0 ? x[from + k] : sine;
        }
    }
}

PCVT_TARGET_CLONES void block_cos(const double* __restrict x, double* __restrict y, int n) {
    ReducedAngles angles;
    for (int from = 0; from < n; from += kAnglesAtOnce) {
        const int n_here = std::min(whole_lanes(n - from), kAnglesAtOnce);
        reduce_angles(x + from, n_here, angles);
        for (int k = 0; k < n_here; ++k) y[from + k] = sine_of(angles, k, 1);
    }
}

PCVT_TARGET_CLONES void block_tan(const double* __restrict x, double* __restrict y, int n) {
    ReducedAngles angles;
    for (int from = 0; from < n; from += kAnglesAtOnce) {
        const int n_here = std::min(whole_lanes(n - from), kAnglesAtOnce);
        reduce_angles(x + from, n_here, angles);
        for (int k = 0; k < n_here; ++k) {
            const double tangent = tangent_of(angles, k);
            y[from + k] = x[from + k] == 0 ? x[from + k] : tangent;
        }
    }
}

PCVT_TARGET_CLONES void block_asin(const double* __restrict x, double* __restrict y, int n) {
    for (int k = 0; k < whole_lanes(n); ++k) y[k] = arc_sine_of(x[k]);
}

PCVT_TARGET_CLONES void block_acos(const double* __restrict x, double* __restrict y, int n) {
    for (int k = 0; k < whole_lanes(n); ++k) y[k] = arc_cosine_of(x[k]);
}

PCVT_TARGET_CLONES void block_atan(const double* __restrict x, double* __restrict y, int n) {
    for (int k = 0; k < whole_lanes(n); ++k) y[k] = arc_tangent_of(x[k]);
}

PCVT_TARGET_CLONES void block_atan2(const double* __restrict a, const double* __restrict b,
                                    double* __restrict y, int n) {
    for (int k = 0; k < whole_lanes(n); ++k) y[k] = angle_of(a[k], b[k]);
}

}  // namespace pcvt
