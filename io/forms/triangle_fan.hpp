#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "mesher/plane/tile/tile.hpp"

namespace pcvt {

/// A point of the plane in single precision.
using Point32 = std::array<float, 2>;
/// The indices of three corners, counter-clockwise.
using FanTriangle = std::array<int, 3>;

/// Splits a convex polygon into a fan of triangles around one of its corners.
///
/// The apex is the corner whose flattest triangle is least flat. A short edge does not make a
/// triangle flat; a corner on the line through the other two does. Triangles without area in
/// float32 are left out, so that a polygon without area gives an empty result.
///
/// @param corners   counter-clockwise, three or more.
/// @param excluded  a corner that is not taken for the apex; -1: each may be.
/// @returns         triples of indices into `corners`.
std::vector<FanTriangle> triangle_fan(std::span<const Point32> corners, int excluded = -1);

/// Returns the vertices of a tile in single precision.
/// @throws CoarsePrecision naming the path if float32 cannot hold a coordinate.
std::vector<Point32> single_precision_points(const plane::Tile& tile, const std::string& path);

/// Appends the corners of the fan of a face of cells, three vertices of the tile per triangle.
///
/// Two pieces of one cell may share an edge. The fan of the second one gets another apex where it
/// would continue the fan of the first, so that readers find the edge between them.
/// @param before  the face whose fan `corners` ends with; -1: there is none.
/// @param points  as single_precision_points() returns them.
/// @throws CoarsePrecision naming the path if the face has no area in float32.
void append_fan(const plane::Tile& cells, int face, int before, const std::vector<Point32>& points,
                std::vector<int>& corners, const std::string& path);

}  // namespace pcvt
