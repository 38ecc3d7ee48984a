#include "mesher/plane/grains/triangle_shape.hpp"

#include <algorithm>
#include <cmath>

#include "mesher/plane/geometry/polygon.hpp"
#include "mesher/portable/portable_angles.hpp"

namespace pcvt::plane {

std::array<double, 3> side_lengths(const std::array<Vec2, 3>& triangle) {
    const auto& [p, q, r] = triangle;
    return {(q - p).norm(), (r - q).norm(), (p - r).norm()};
}

double smallest_sine(const std::array<Vec2, 3>& triangle) {
    const auto& [p, q, r] = triangle;
    std::array<double, 3> sides = side_lengths(triangle);
    std::sort(sides.begin(), sides.end());
    // The smallest angle lies between the two longer sides.
    return cross(q - p, r - p) / (sides[1] * sides[2]);
}

double angle_at(const std::array<Vec2, 3>& triangle, int k) {
    const Vec2& corner = triangle[static_cast<std::size_t>(k)];
    const Vec2 to_next = triangle[static_cast<std::size_t>((k + 1) % 3)] - corner;
    const Vec2 to_previous = triangle[static_cast<std::size_t>((k + 2) % 3)] - corner;
    return portable_atan2(cross(to_next, to_previous), to_next.dot(to_previous)) * 180 / M_PI;
}

Vec2 circumcentre(const std::array<Vec2, 3>& triangle) {
    const Vec2 p = triangle[1] - triangle[0];
    const Vec2 q = triangle[2] - triangle[0];
    const Vec2 weighted = p.squaredNorm() * q - q.squaredNorm() * p;
    return triangle[0] + Vec2(weighted.y(), -weighted.x()) / (2 * cross(p, q));
}

}  // namespace pcvt::plane
