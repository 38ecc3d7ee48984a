#include "io/forms/triangle_fan.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "io/bytes/output_error.hpp"

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
/// does not exceed `bar`.
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

std::vector<FanTriangle> triangle_fan(std::span<const Point32> corners, int excluded) {
    int best = excluded == 0 ? 1 : 0;
    double best_openness = -std::numeric_limits<double>::infinity();
    for (int apex = 0; apex < static_cast<int>(corners.size()); ++apex) {
        if (apex == excluded) continue;
        const double apex_openness = worst_openness(corners, apex, best_openness);
        if (apex_openness > best_openness) {
            best = apex;
            best_openness = apex_openness;
        }
    }
    return fan_from(corners, best);
}

std::vector<Point32> single_precision_points(const plane::Tile& tile, const std::string& path) {
    std::vector<Point32> points;
    points.reserve(tile.points.size());
    for (const plane::Vec2& p : tile.points) {
        // Adding zero turns -0 into 0.
        points.push_back({static_cast<float>(p.x()) + 0.0f, static_cast<float>(p.y()) + 0.0f});
        if (!std::isfinite(points.back()[0]) || !std::isfinite(points.back()[1])) {
            throw CoarsePrecision(path +
                                  ": coordinates too large for float32; write another format");
        }
    }
    return points;
}

void append_fan(const plane::Tile& cells, int face, int before, const std::vector<Point32>& points,
                std::vector<int>& corners, const std::string& path) {
    std::vector<Point32> polygon;
    for (const int v : cells.faces[face]) polygon.push_back(points[v]);
    const auto vertex = [&](int k) { return cells.faces[face][k]; };
    std::vector<FanTriangle> fan = triangle_fan(polygon);
    if (before >= 0 && !fan.empty() && cells.face_site[before] == cells.face_site[face]) {
        const auto last = std::span(corners).last<3>();
        const FanTriangle& first = fan.front();
        const bool continues = vertex(first[0]) == last[0] && vertex(first[1]) == last[2];
        if (continues) fan = triangle_fan(polygon, first[0]);
    }
    if (fan.empty()) {
        throw CoarsePrecision(
            path + ": the cell of site " + std::to_string(cells.face_site[face]) +
            " has no area in float32; write another format or bring the tile nearer to the origin");
    }
    for (const FanTriangle& triangle : fan) {
        for (const int corner : triangle) corners.push_back(vertex(corner));
    }
}

}  // namespace pcvt
