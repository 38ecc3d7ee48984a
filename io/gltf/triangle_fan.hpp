#pragma once

#include <array>
#include <span>
#include <vector>

namespace pcvt {

/// A point of the plane as glTF stores it.
using Point32 = std::array<float, 2>;
/// Indices of corners, counter-clockwise.
using FanTriangle = std::array<int, 3>;

/// The triangles of a convex polygon, as a fan round one of its corners.
///
/// The corner is the one whose worst triangle is the furthest from flat; a short edge does not make
/// a triangle bad, a corner on the line of the other two does. Triangles without area in float32
/// are left out, so the result is empty where the whole polygon has none.
///
/// @param corners counter-clockwise, three or more.
/// @returns       triples of 0 ... corners.size() - 1.
std::vector<FanTriangle> triangle_fan(std::span<const Point32> corners);

}  // namespace pcvt
