#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

namespace pcvt::space {

using Point2 = Eigen::Vector2d;

inline double dot2(const Point2& a, const Point2& b) { return a.x() * b.x() + a.y() * b.y(); }
inline double cross2(const Point2& a, const Point2& b) { return a.x() * b.y() - a.y() * b.x(); }
inline double square(const Point2& a) { return dot2(a, a); }

/// The largest coordinate of points.
double extent_of(const std::vector<Point2>& points);

/// Whether a triangle is flat: its height over its longest edge is not far above the rounding of
/// coordinates, or it is clockwise.
/// @param area2    twice its area.
/// @param squares  the sum of the squares of two or three of its edges, the longest among them.
/// @param extent   extent_of() all points of the face.
bool is_flat_triangle(double area2, double squares, double extent);

/// The sine of the smallest angle of a triangle; negative where it is clockwise.
double smallest_sine(const Point2& a, const Point2& b, const Point2& c);

/// Cuts a polygon into triangles, always the ear with the widest smallest angle. No triangle has
/// three points of one straight side.
///
/// Example usage:
///     const std::vector<std::array<int, 3>> triangles = cut_ears(polygon);
///
/// @param polygon  convex or slightly concave, counter-clockwise; may have points on its sides. If
///                 no ear is left, gets its centroid.
std::vector<std::array<int, 3>> cut_ears(std::vector<Point2>& polygon);

}  // namespace pcvt::space
