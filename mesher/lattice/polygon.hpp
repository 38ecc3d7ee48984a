#pragma once

#include <vector>

#include "mesher/lattice/lattice.hpp"

namespace pcvt {

/// Corners in order; all measures are positive counter-clockwise.
using Polygon = std::vector<Vec2>;

inline double cross(const Vec2& p, const Vec2& q) { return p.x() * q.y() - p.y() * q.x(); }

double polygon_area(const Polygon& polygon);
double polygon_perimeter(const Polygon& polygon);
/// @pre the area is not zero.
Vec2 polygon_centroid(const Polygon& polygon);

/// The part of a convex polygon where normal . p <= level (Sutherland and Hodgman's clipping by one
/// half-plane); no corner where nothing is left.
Polygon clipped(const Polygon& polygon, const Vec2& normal, double level);

/// The largest distance by which a corner lies behind the chord between its neighbours: 0 where the
/// polygon turns left everywhere.
double reflex_depth(const Polygon& polygon);

/// Whether two sides cross each other by more than `tolerance`. Polygons that turn left everywhere
/// and once round are known to have no crossing; the others cost the square of their corners.
bool crosses_itself(const Polygon& polygon, double tolerance);

}  // namespace pcvt
