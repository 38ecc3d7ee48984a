#pragma once

#include <array>

#include "mesher/plane/geometry/lattice.hpp"

namespace pcvt::plane {

/// The angles of grain triangles exceed this, degrees, except at corners of cells that are sharper
/// themselves.
inline constexpr double kSmallestAngle = 20;

// Measures of a triangle whose corners run counter-clockwise, length units. Example usage:
//
//     const std::array<Vec2, 3> triangle = {Vec2(0, 0), Vec2(1, 0), Vec2(0, 1)};
//     const double smallest = std::asin(smallest_sine(triangle)) * 180 / M_PI;  // 45
//     const Vec2 centre = circumcentre(triangle);                               // (0.5, 0.5)

/// Lengths of the sides: 0 from corner 0 to 1, 1 from 1 to 2, 2 from 2 to 0.
std::array<double, 3> side_lengths(const std::array<Vec2, 3>& triangle);

/// The sine of the smallest angle; at most 0 for a triangle that is not counter-clockwise.
double smallest_sine(const std::array<Vec2, 3>& triangle);

/// The angle at corner k, degrees.
double angle_at(const std::array<Vec2, 3>& triangle, int k);

/// The point equidistant from the three corners.
Vec2 circumcentre(const std::array<Vec2, 3>& triangle);

}  // namespace pcvt::plane
