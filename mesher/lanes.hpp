#pragma once

namespace pcvt {

/// Numbers side by side, for functions with PCVT_VECTOR_CLONES in which the compiler would not find
/// them itself: the inner loop of a sum over points, outside of it many sums. An operation on lanes
/// is that operation on each, so results do not depend on how wide a vector unit is.
using Lanes = double __attribute__((vector_size(64)));
inline constexpr int kLanes = 8;
/// A point in the plane.
using Pair = double __attribute__((vector_size(16)));
/// A point in the plane and in lattice coordinates.
using Quad = double __attribute__((vector_size(32)));

}  // namespace pcvt
