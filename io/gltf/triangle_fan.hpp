#pragma once

#include <array>
#include <span>
#include <vector>

namespace pcvt {

/// A point of the plane as glTF stores it.
using Point32 = std::array<float, 2>;
/// The indices of three corners, counter-clockwise.
using FanTriangle = std::array<int, 3>;

/// Splits a convex polygon into a fan of triangles around one of its corners.
///
/// The apex is the corner whose flattest triangle is least flat. A short edge does not make a
/// triangle flat; a corner on the line through the other two does. Triangles without area in
/// float32 are left out, so that a polygon without area gives an empty result.
///
/// @param corners counter-clockwise, three or more.
/// @returns       triples of indices into `corners`.
std::vector<FanTriangle> triangle_fan(std::span<const Point32> corners);

}  // namespace pcvt
