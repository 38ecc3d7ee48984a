#pragma once

#include <array>

namespace pcvt {

/// Doubles that are processed side by side (vector extension of GCC and Clang), for loops that the
/// compiler does not vectorise itself because the inner loop is a sum over points and the outer
/// loop runs over many such sums. Each operation is elementwise, so results do not depend on the
/// vector width of the machine; PCVT_TARGET_CLONES makes full use of that width. Values are loaded
/// and stored by std::memcpy, because arrays need not be aligned to a vector.
///
/// Example usage:
///
///     Lanes x;
///     std::memcpy(&x, values, sizeof x);
///     x = 2 * x + 1;
///     std::memcpy(values, &x, sizeof x);
inline constexpr int kLanes = 8;
using Lanes = double __attribute__((vector_size(kLanes * sizeof(double))));
/// n >= 0, rounded up to a multiple of kLanes: the numbers that a loop over lanes reads and writes.
constexpr int whole_lanes(int n) { return (n + (kLanes - 1)) & -kLanes; }
/// A point in the plane.
using Pair = double __attribute__((vector_size(2 * sizeof(double))));
/// A DensityPoint.
using Quad = double __attribute__((vector_size(4 * sizeof(double))));

/// Turns the rows of a matrix into its columns.
[[gnu::always_inline]] inline void transpose(std::array<Quad, 4>& rows) {
    const auto& [a, b, c, d] = rows;
    const Quad ab_even = __builtin_shufflevector(a, b, 0, 4, 2, 6);
    const Quad ab_odd = __builtin_shufflevector(a, b, 1, 5, 3, 7);
    const Quad cd_even = __builtin_shufflevector(c, d, 0, 4, 2, 6);
    const Quad cd_odd = __builtin_shufflevector(c, d, 1, 5, 3, 7);
    rows = {__builtin_shufflevector(ab_even, cd_even, 0, 1, 4, 5),
            __builtin_shufflevector(ab_odd, cd_odd, 0, 1, 4, 5),
            __builtin_shufflevector(ab_even, cd_even, 2, 3, 6, 7),
            __builtin_shufflevector(ab_odd, cd_odd, 2, 3, 6, 7)};
}

}  // namespace pcvt
