#include "io/gltf/triangle_fan.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcvt {
namespace {

double squared_distance(const Point32& p, const Point32& q) {
    const double dx = double(q[0]) - p[0];
    const double dy = double(q[1]) - p[1];
    return dx * dx + dy * dy;
}

double doubled_area(const Point32& p, const Point32& q, const Point32& r) {
    return (double(q[0]) - p[0]) * (double(r[1]) - p[1]) -
           (double(q[1]) - p[1]) * (double(r[0]) - p[0]);
}

/// Returns the sine of the angle between the longest and the shortest edge: near 0 for three
/// corners almost on one line, negative for a clockwise triangle, but not small for one short edge.
double openness(const Point32& p, const Point32& q, const Point32& r) {
    const auto [shortest, longest] =
        std::minmax({squared_distance(p, q), squared_distance(q, r), squared_distance(r, p)});
    return doubled_area(p, q, r) / (std::sqrt(shortest) * std::sqrt(longest));
}

std::vector<FanTriangle> fan_from(std::span<const Point32> corners, int apex) {
    const int n = static_cast<int>(corners.size());
    const auto at = [&](int k) { return corners[static_cast<std::size_t>(k)]; };
    std::vector<FanTriangle> fan;
    for (int k = 1; k + 1 < n; ++k) {
        const FanTriangle triangle{apex, (apex + k) % n, (apex + k + 1) % n};
        if (doubled_area(at(triangle[0]), at(triangle[1]), at(triangle[2])) != 0) {
            fan.push_back(triangle);
        }
    }
    return fan;
}

/// Returns the least openness of the triangles around `apex`, or that of the first triangle which
/// is no better than `bar`.
double worst_openness(std::span<const Point32> corners, int apex, double bar) {
    const int n = static_cast<int>(corners.size());
    const auto at = [&](int k) { return corners[static_cast<std::size_t>((apex + k) % n)]; };
    double worst = std::numeric_limits<double>::infinity();
    for (int k = 1; k + 1 < n && worst > bar; ++k) {
        const bool collapsed = at(0) == at(k) || at(k) == at(k + 1) || at(k + 1) == at(0);
        if (!collapsed) worst = std::min(worst, openness(at(0), at(k), at(k + 1)));
    }
    return worst;
}

}  // namespace

std::vector<FanTriangle> triangle_fan(std::span<const Point32> corners) {
    int best = 0;
    double best_openness = -std::numeric_limits<double>::infinity();
    for (int apex = 0; apex < static_cast<int>(corners.size()); ++apex) {
        const double apex_openness = worst_openness(corners, apex, best_openness);
        if (apex_openness > best_openness) {
            best = apex;
            best_openness = apex_openness;
        }
    }
    return fan_from(corners, best);
}

}  // namespace pcvt
