#pragma once

#include <cstdint>

#include "mesher/formula/number_parts.hpp"

namespace pcvt {

/// An angle of n quarter turns and a rest, n modulo 2^64.
struct ReducedAngle {
    /// At most pi / 4, up to rounding.
    NumberPair rest;
    std::uint64_t n_quarters;
};

/// Reduces an angle by quarter turns, however large it is (M. H. Payne, R. N. Hanek 1983): only
/// those bits of 2 / pi take part whose products with the angle are not multiples of 4.
///
/// Example usage:
///     const ReducedAngle angle = reduce_huge_angle(1e300);
///
/// @param radians  at least 1 in size; an infinite angle or NaN gives a rest of NaN.
ReducedAngle reduce_huge_angle(double radians);

}  // namespace pcvt
