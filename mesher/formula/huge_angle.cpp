#include "mesher/formula/huge_angle.hpp"

#include <cmath>
#include <limits>

namespace pcvt {
namespace {

/// The first 1216 bits of 2 / pi.
constexpr std::uint64_t kTwoOverPi[] = {
    0xa2f9836e4e441529, 0xfc2757d1f534ddc0, 0xdb6295993c439041, 0xfe5163abdebbc561,
    0xb7246e3a424dd2e0, 0x06492eea09d1921c, 0xfe1deb1cb129a73e, 0xe88235f52ebb4484,
    0xe99c7026b45f7e41, 0x3991d639835339f4, 0x9c845f8bbdf9283b, 0x1ff897ffde05980f,
    0xef2f118b5a0a6d1f, 0x6d367ecf27cb09b7, 0x4f463f669e5fea2d, 0x7527bac7ebe5f17b,
    0x3d0739f78a5292ea, 0x6bfb5fb11f8d5d08, 0x56033046fc7b6bab};
constexpr int kParts = 6;
constexpr int kPartBits = 32;

/// 32 bits of 2 / pi from that of weight 2^-first on; bits before the first one are 0.
std::uint32_t bits_of_two_over_pi(int first) {
    std::uint32_t bits = 0;
    for (int k = first; k < first + kPartBits; ++k) {
        const bool is_set = k >= 1 && (kTwoOverPi[(k - 1) / 64] >> (63 - (k - 1) % 64) & 1) != 0;
        bits = bits << 1 | (is_set ? 1 : 0);
    }
    return bits;
}

/// A number of 192 bits, its least part first.
using Parts = std::array<std::uint32_t, kParts>;

/// The product modulo 2^192.
Parts product(const Parts& a, std::uint64_t b) {
    Parts sum{};
    for (int shift = 0; shift < 2; ++shift) {
        const std::uint64_t factor = b >> (kPartBits * shift) & 0xffffffff;
        std::uint64_t carry = 0;
        for (int k = 0; k + shift < kParts; ++k) {
            carry += a[k] * factor + sum[k + shift];
            sum[k + shift] = static_cast<std::uint32_t>(carry);
            carry >>= kPartBits;
        }
    }
    return sum;
}

void negate(Parts& parts) {
    std::uint64_t carry = 1;
    for (std::uint32_t& part : parts) {
        carry += static_cast<std::uint32_t>(~part);
        part = static_cast<std::uint32_t>(carry);
        carry >>= kPartBits;
    }
}

}  // namespace

ReducedAngle reduce_huge_angle(double radians) {
    if (!std::isfinite(radians)) {
        return {{std::numeric_limits<double>::quiet_NaN(), 0}, 0};
    }
    // |radians| = digits 2^exponent.
    int exponent = 0;
    const double fraction = std::frexp(std::abs(radians), &exponent);
    const auto digits = static_cast<std::uint64_t>(std::ldexp(fraction, 53));
    exponent -= 53;
    // Quarter turns are the product with 2 / pi, modulo 4, in units of 2^-190.
    Parts two_over_pi{};
    for (int k = 0; k < kParts; ++k) {
        two_over_pi[kParts - 1 - k] = bits_of_two_over_pi(exponent - 1 + kPartBits * k);
    }
    Parts turns = product(two_over_pi, digits);
    // Split them into the nearest whole number and the rest, from -1/2 to 1/2.
    std::uint64_t n_quarters = turns[kParts - 1] >> 30;
    turns[kParts - 1] &= 0x3fffffff;
    const bool is_above = (turns[kParts - 1] >> 29) != 0;
    if (is_above) {
        // Less by 1, and then its size.
        turns[kParts - 1] |= 0xc0000000;
        negate(turns);
        ++n_quarters;
    }
    NumberPair rest{0, 0};
    for (int k = kParts - 1; k >= 0; --k) {
        const double part = std::ldexp(turns[k], kPartBits * k - 190);
        const auto [sum, error] = exact_sum_of_ordered(rest.high, part);
        rest = {sum, rest.low + error};
    }
    // Multiply by pi / 2.
    constexpr double kHigh = 0x1.921fb54442d18p+0;
    constexpr double kLow = 0x1.1a62633145c07p-54;
    const double lead = leading_half(rest.high);
    const double half_pi_lead = leading_half(kHigh);
    const double high = rest.high * kHigh;
    const double error = (((lead * half_pi_lead - high) + lead * (kHigh - half_pi_lead)) +
                          (rest.high - lead) * half_pi_lead) +
                         (rest.high - lead) * (kHigh - half_pi_lead);
    const double low = error + (rest.low * kHigh + rest.high * kLow);
    const bool is_negative = is_above != std::signbit(radians);
    const double sign = is_negative ? -1 : 1;
    return {{sign * high, sign * low}, std::signbit(radians) ? 0 - n_quarters : n_quarters};
}

}  // namespace pcvt
