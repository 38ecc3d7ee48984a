#include "mesher/plane/geometry/polygon.hpp"

#include <algorithm>
#include <cmath>

namespace pcvt::plane {
namespace {

const Vec2& cyclic(const Polygon& polygon, std::size_t k) { return polygon[k % polygon.size()]; }

/// The number of full turns of a polygon that turns left at every corner: counts the sides after
/// which the direction leaves the upper half plane.
int turns(const Polygon& polygon) {
    const auto upwards = [&](std::size_t k) {
        const Vec2 side = cyclic(polygon, k + 1) - polygon[k % polygon.size()];
        return side.y() > 0 || (side.y() == 0 && side.x() > 0);
    };
    int count = 0;
    for (std::size_t k = 0; k < polygon.size(); ++k) count += upwards(k) && !upwards(k + 1);
    return count;
}

/// Returns +1 or -1 if r lies further than `tolerance` to the left or right of the line p q, else
/// 0.
int side_of(const Vec2& p, const Vec2& q, const Vec2& r, double tolerance) {
    const double distance = cross(q - p, r - p) / (q - p).norm();
    return (distance > tolerance) - (distance < -tolerance);
}

bool segments_cross(const Vec2& p, const Vec2& q, const Vec2& r, const Vec2& s, double tolerance) {
    return side_of(p, q, r, tolerance) * side_of(p, q, s, tolerance) < 0 &&
           side_of(r, s, p, tolerance) * side_of(r, s, q, tolerance) < 0;
}

}  // namespace

double polygon_area(const Polygon& polygon) {
    double twice = 0;
    for (std::size_t k = 1; k + 1 < polygon.size(); ++k) {
        twice += cross(polygon[k] - polygon[0], polygon[k + 1] - polygon[0]);
    }
    return twice / 2;
}

double polygon_perimeter(const Polygon& polygon) {
    double sum = 0;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        sum += (cyclic(polygon, k + 1) - polygon[k]).norm();
    }
    return sum;
}

Vec2 polygon_centroid(const Polygon& polygon) {
    double twice = 0;
    Vec2 moment(0, 0);
    for (std::size_t k = 1; k + 1 < polygon.size(); ++k) {
        const Vec2 p = polygon[k] - polygon[0];
        const Vec2 q = polygon[k + 1] - polygon[0];
        twice += cross(p, q);
        moment += cross(p, q) * (p + q);
    }
    return polygon[0] + moment / (3 * twice);
}

Polygon clipped(const Polygon& polygon, const Vec2& normal, double level) {
    Polygon kept;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const Vec2& p = polygon[k];
        const Vec2& q = cyclic(polygon, k + 1);
        const double fp = normal.dot(p) - level;
        const double fq = normal.dot(q) - level;
        if (fp <= 0) kept.push_back(p);
        if ((fp < 0 && fq > 0) || (fp > 0 && fq < 0)) kept.push_back(p + fp / (fp - fq) * (q - p));
    }
    return kept;
}

double reflex_depth(const Polygon& polygon) {
    double depth = 0;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const Vec2 in = cyclic(polygon, k + 1) - polygon[k];
        const Vec2 out = cyclic(polygon, k + 2) - cyclic(polygon, k + 1);
        const double turn = cross(in, out);
        if (turn < 0) depth = std::max(depth, -turn / (in + out).norm());
    }
    return depth;
}

bool crosses_itself(const Polygon& polygon, double tolerance) {
    const std::size_t n = polygon.size();
    if (n <= 3 || (reflex_depth(polygon) == 0 && turns(polygon) == 1)) return false;
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = i + 2; j < n; ++j) {
            if (segments_cross(polygon[i], cyclic(polygon, i + 1), polygon[j],
                               cyclic(polygon, j + 1), tolerance)) {
                return true;
            }
        }
    }
    return false;
}

}  // namespace pcvt::plane
