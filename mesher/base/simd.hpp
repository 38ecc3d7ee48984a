#pragma once

namespace pcvt {

/// Numbers side by side (vector extension of GCC and Clang), for loops in which the compiler does
/// not find them itself: there a sum over points is the inner loop, and many sums are the outer
/// one. An operation is the same on each number, so no result depends on how wide the machine's
/// vectors are; with PCVT_TARGET_CLONES they are as wide as they can be. Loaded and stored by
/// std::memcpy, since they may stand anywhere.
inline constexpr int kLanes = 8;
using Lanes = double __attribute__((vector_size(kLanes * sizeof(double))));
/// A point in the plane.
using Pair = double __attribute__((vector_size(2 * sizeof(double))));
/// A DensityPoint.
using Quad = double __attribute__((vector_size(4 * sizeof(double))));

}  // namespace pcvt
