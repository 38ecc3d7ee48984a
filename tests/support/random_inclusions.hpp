#pragma once

#include <cmath>
#include <numbers>
#include <random>

#include "mesher/base/error.hpp"
#include "mesher/plane/interfaces/inclusion_set.hpp"

namespace pcvt::testing {

/// Whether two shapes, the second one translated, are not apart.
inline bool shapes_meet(const plane::Shape& first, const plane::Shape& second,
                        const plane::Vec2& translation) {
    return shape_relation(first, second, translation) != plane::ShapeRelation::kApart;
}

/// Points on the curve, in order.
inline plane::Polygon points_on(const plane::Shape& shape, int n) {
    plane::Polygon points;
    if (const auto* polygon = std::get_if<plane::Polygon>(&shape)) {
        for (std::size_t k = 0; k < polygon->size(); ++k) {
            const plane::Vec2 side = (*polygon)[(k + 1) % polygon->size()] - (*polygon)[k];
            for (int m = 0; m < n; ++m) points.push_back((*polygon)[k] + double(m) / n * side);
        }
        return points;
    }
    const auto* circle = std::get_if<plane::Circle>(&shape);
    const plane::EllipseAxes axes =
        circle ? ellipse_axes(*circle) : ellipse_axes(std::get<plane::Ellipse>(shape));
    for (int m = 0; m < n; ++m) points.push_back(axes.at_degrees(360.0 * m / n));
    return points;
}

struct RandomInclusions {
    int n_shapes = 5;
    /// The number of shapes, the first ones, that lie across the seam or a corner of the domain.
    int n_across = 0;
    double fraction = 0.3;
    /// In units of sqrt(area).
    double gap = 0.02;
    /// Polygons have no smaller angle, degrees.
    double sharpest = 20;
    /// Twice the gap separates shapes from walls.
    Walls walls = Walls::kNone;
};

/// A star-shaped polygon round `centre` of about the given radius.
inline plane::Polygon random_polygon(const plane::Vec2& centre, double radius,
                                     std::mt19937_64& random) {
    std::uniform_real_distribution<double> unit(0, 1);
    const int n = 3 + int(6 * unit(random));
    const double turn = 2 * std::numbers::pi * unit(random);
    plane::Polygon polygon;
    for (int k = 0; k < n; ++k) {
        const double angle = turn + 2 * std::numbers::pi * (k + 0.8 * unit(random)) / n;
        const double r = radius * (0.5 + 0.7 * unit(random));
        polygon.push_back(centre + r * plane::Vec2(std::cos(angle), std::sin(angle)));
    }
    return polygon;
}

inline double sharpest_angle(const plane::Polygon& polygon) {
    double least = 180;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const std::size_t n = polygon.size();
        const plane::Vec2 p = (polygon[(k + 1) % n] - polygon[k]).normalized();
        const plane::Vec2 q = (polygon[(k + n - 1) % n] - polygon[k]).normalized();
        least = std::min(least, std::acos(std::clamp(p.dot(q), -1.0, 1.0)));
    }
    return least * 180 / std::numbers::pi;
}

/// A circle, an ellipse or a polygon.
inline plane::Shape random_shape(const plane::Vec2& centre, double radius,
                                 std::mt19937_64& random) {
    std::uniform_real_distribution<double> unit(0, 1);
    const int kind = int(3 * unit(random));
    if (kind == 0) return plane::Circle{centre, radius};
    if (kind == 2) return random_polygon(centre, radius, random);
    const double aspect = std::sqrt(1 + 2 * unit(random));
    return plane::Ellipse{centre, radius * aspect, radius / aspect, 360 * unit(random)};
}

/// Shapes of random kinds and sizes that keep the gap; fewer than n_shapes where no more fit.
inline std::vector<plane::Inclusion> random_inclusions(const plane::Lattice& lattice,
                                                       const RandomInclusions& wanted,
                                                       std::mt19937_64& random) {
    std::uniform_real_distribution<double> unit(0, 1);
    const double gap = wanted.gap * std::sqrt(lattice.area());
    const double mean =
        std::sqrt(wanted.fraction * lattice.area() / wanted.n_shapes / std::numbers::pi);
    std::vector<plane::Inclusion> inclusions;
    for (int attempt = 0; attempt < 300 * wanted.n_shapes; ++attempt) {
        const int k = int(inclusions.size());
        if (k == wanted.n_shapes) break;
        plane::Vec2 u(unit(random), unit(random));
        if (k < wanted.n_across) u[0] = 0;
        if (k < wanted.n_across && k % 2 == 1) u[1] = 0;
        const plane::Vec2 centre = lattice.to_position(u);
        const double radius = mean * (0.6 + 0.6 * unit(random));
        const plane::Shape shape = random_shape(centre, radius, random);
        const auto* polygon = std::get_if<plane::Polygon>(&shape);
        if (polygon != nullptr && sharpest_angle(*polygon) < wanted.sharpest) continue;
        inclusions.push_back({shape, 1 + k % 3, k + 1});
        bool fits = true;
        try {
            const plane::InclusionSet set(lattice, inclusions, wanted.walls);
            for (int i = 0; i <= k; ++i) fits = fits && set.parent(i) < 0;
            for (const plane::Vec2& p : points_on(shape, 40)) {
                fits = fits && set.distance_to_others(k, p, 2 * gap) >= gap;
            }
        } catch (const InvalidInput&) {
            fits = false;
        }
        if (!fits) inclusions.pop_back();
    }
    return inclusions;
}

}  // namespace pcvt::testing
