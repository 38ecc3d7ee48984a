#pragma once

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
/// A point in the plane.
using Pair = double __attribute__((vector_size(2 * sizeof(double))));
/// A DensityPoint.
using Quad = double __attribute__((vector_size(4 * sizeof(double))));

}  // namespace pcvt
