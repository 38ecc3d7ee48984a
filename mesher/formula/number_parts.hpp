#pragma once

#include <array>
#include <cstdint>

namespace pcvt {

// Parts of numbers, from operations that every vector unit has: additions and shifts of integers,
// no comparisons of 64-bit integers and no conversions. The functions are inlined into the loops
// of block_exponentials.cpp and its neighbours, which the compiler vectorises.
//
// Example usage:
//
//     const double k = nearest_whole(x * (1 / std::numbers::ln2));
//     return polynomial(x - k * std::numbers::ln2, kCoefficients) * power_of_two(k);

#define PCVT_IN_LANES [[gnu::always_inline]] inline

/// A sum high + low that is not rounded to one number.
struct NumberPair {
    double high;
    double low;
};

// std::bit_cast, which the library of Emscripten lacks.
PCVT_IN_LANES std::uint64_t bits_of(double x) { return __builtin_bit_cast(std::uint64_t, x); }
PCVT_IN_LANES double from_bits(std::uint64_t bits) { return __builtin_bit_cast(double, bits); }

inline constexpr std::uint64_t kSignBit = std::uint64_t{1} << 63;

PCVT_IN_LANES double magnitude_of(double x) { return from_bits(bits_of(x) & ~kSignBit); }
/// Returns x with the sign of another number.
/// @param x  not negative, or of that sign.
PCVT_IN_LANES double with_sign_of(double sign, double x) {
    return from_bits(bits_of(x) | (bits_of(sign) & kSignBit));
}
/// Returns x where the last bit of `choice` is set, otherwise y.
PCVT_IN_LANES double choose_by_bit(std::uint64_t choice, double x, double y) {
    const std::uint64_t mask = 0 - (choice & 1);
    return from_bits((bits_of(x) & mask) | (bits_of(y) & ~mask));
}
/// The leading 26 bits of a number: products of two such numbers are exact.
PCVT_IN_LANES double leading_half(double x) { return from_bits(bits_of(x) & ~0x7ffffffull); }

/// Adding it rounds a number below 2^51 to a whole one, which the last bits of the sum hold.
inline constexpr double kToWhole = 0x1.8p52;
/// @param x  |x| < 2^51.
PCVT_IN_LANES double nearest_whole(double x) { return (x + kToWhole) - kToWhole; }

/// The whole number that is nearest to x, which the second one of two equally near ones is if it is
/// even.
PCVT_IN_LANES double nearest_whole_of_any(double x) {
    const double size = magnitude_of(x);
    const double whole = (size + 0x1p52) - 0x1p52;
    return with_sign_of(x, size < 0x1p52 ? whole : size);
}

/// 2^k for a whole k from -1022 to 1023.
PCVT_IN_LANES double power_of_two(double k) {
    return from_bits((bits_of(k + kToWhole) << 52) + bits_of(1.0));
}
/// x 2^k for a whole k from -2000 to 2000, rounded once.
/// @param x  from 1/2 to 2.
PCVT_IN_LANES double times_power_of_two(double x, double k) {
    const double half = nearest_whole(k * 0.5);
    return x * power_of_two(half) * power_of_two(k - half);
}

/// The sum of two numbers and its rounding error.
PCVT_IN_LANES NumberPair exact_sum(double a, double b) {
    const double sum = a + b;
    const double part = sum - a;
    return {sum, (a - (sum - part)) + (b - part)};
}
/// The same for |a| >= |b| or a = 0.
PCVT_IN_LANES NumberPair exact_sum_of_ordered(double a, double b) {
    const double sum = a + b;
    return {sum, b - (sum - a)};
}

/// The polynomial with these coefficients, that of x^0 first. Even and odd powers are summed side
/// by side, because the time of a loop follows from the longest chain of operations.
template <std::size_t N>
PCVT_IN_LANES double polynomial(double x, const std::array<double, N>& coefficients) {
    const double z = x * x;
    double sum = coefficients[N - 1];
    double other = coefficients[N - 2];
    for (std::size_t k = N - 2; k-- > 0;) {
        const double next = sum * z + coefficients[k];
        sum = other;
        other = next;
    }
    // Now `other` belongs to x^0 and `sum` to x^1.
    return other + sum * x;
}

}  // namespace pcvt
