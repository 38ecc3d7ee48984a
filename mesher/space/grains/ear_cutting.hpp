#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

namespace pcvt::space {

using Point2 = Eigen::Vector2d;

inline double dot2(const Point2& a, const Point2& b) { return a.x() * b.x() + a.y() * b.y(); }
inline double cross2(const Point2& a, const Point2& b) { return a.x() * b.y() - a.y() * b.x(); }
inline double square(const Point2& a) { return dot2(a, a); }

/// A triangle is flat where twice its area is below this part of the sum of its squared edges: far
/// above rounding.
inline constexpr double kFlatTriangle = 1e-9;

/// The sine of the smallest angle of a triangle; negative where it is clockwise.
double smallest_sine(const Point2& a, const Point2& b, const Point2& c);

/// Cuts a polygon into triangles, always the ear with the widest smallest angle. No triangle has
/// three points of one straight side.
///
/// Example usage:
///     const std::vector<std::array<int, 3>> triangles = cut_ears(polygon);
///
/// @param polygon  convex or slightly concave, counter-clockwise; may have points on its sides. If
///                 no ear is left, gets a point in the middle of what is left.
std::vector<std::array<int, 3>> cut_ears(std::vector<Point2>& polygon);

}  // namespace pcvt::space
