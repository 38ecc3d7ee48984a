#pragma once

#include <array>

#include "mesher/lattice/lattice.hpp"

namespace pcvt {

/// Angles of grains are larger than this, degrees, but for corners of cells that are sharper
/// themselves.
inline constexpr double kSmallestAngle = 20;

// Measures of a triangle whose corners run counter-clockwise, length units.

/// Lengths of the sides: 0 from corner 0 to 1, 1 from 1 to 2, 2 from 2 to 0.
std::array<double, 3> side_lengths(const std::array<Vec2, 3>& triangle);

/// The sine of the smallest angle; not above 0 where the triangle is turned over.
double smallest_sine(const std::array<Vec2, 3>& triangle);

/// The angle at corner k, degrees.
double angle_at(const std::array<Vec2, 3>& triangle, int k);

/// The point at equal distance of the three corners.
Vec2 circumcentre(const std::array<Vec2, 3>& triangle);

}  // namespace pcvt
