#pragma once

#include <vector>

#include "mesher/plane/geometry/lattice.hpp"

namespace pcvt::plane {

/// The corners in order. Area and turns are positive counter-clockwise.
///
/// Example usage:
///
///     const Polygon square = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
///     const Polygon lower = clipped(square, {0, 1}, 0.5);  // y <= 0.5
///     const Vec2 centre = polygon_centroid(lower);         // (0.5, 0.25)
using Polygon = std::vector<Vec2>;

/// Returns p turned by a quarter, counter-clockwise.
inline Vec2 turned_left(const Vec2& p) { return {-p.y(), p.x()}; }
inline double cross(const Vec2& p, const Vec2& q) { return p.x() * q.y() - p.y() * q.x(); }

double polygon_area(const Polygon& polygon);
double polygon_perimeter(const Polygon& polygon);
/// @pre the area is not zero.
Vec2 polygon_centroid(const Polygon& polygon);

/// The part of a convex polygon where normal . p <= level (Sutherland and Hodgman's clipping by one
/// half-plane); empty if nothing remains.
Polygon clipped(const Polygon& polygon, const Vec2& normal, double level);

/// The largest distance of a reflex corner from the chord between its neighbours; 0 if the polygon
/// turns left at every corner.
double reflex_depth(const Polygon& polygon);

/// Whether two sides cross each other by more than `tolerance`. A polygon that turns left at every
/// corner and once in total has no crossing; any other polygon costs the square of its number of
/// corners.
bool crosses_itself(const Polygon& polygon, double tolerance);

}  // namespace pcvt::plane
