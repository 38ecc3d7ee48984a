#include "mesher/plane/interfaces/inclusion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "mesher/plane/interfaces/polygon_sides.hpp"
#include "mesher/portable/portable_angles.hpp"

namespace pcvt::plane {
namespace {

/// Curves nearer to each other than this, in units of the size of a shape, touch.
constexpr double kTouching = 1e-9;
constexpr int kMostSteps = 200;

template <class... Functions>
struct Overloaded : Functions... {
    using Functions::operator()...;
};
template <class... Functions>
Overloaded(Functions...) -> Overloaded<Functions...>;

/// The distance of (x, y), both positive, from the ellipse with semi-axes a >= b along x and y.
/// The foot is (a^2 x / (s + a^2), b^2 y / (s + b^2)) with s the largest root of a convex, falling
/// function (D. Eberly); Newton's iteration rises towards the root from the left.
double distance_in_quadrant(double a, double b, double x, double y) {
    if (y == 0 && a * x < a * a - b * b) {
        const double cosine = a * x / (a * a - b * b);
        const double sine = std::sqrt((1 - cosine) * (1 + cosine));
        return Vec2(a * cosine - x, b * sine).norm();
    }
    if (y == 0) return std::abs(x - a);
    // t = (s + b^2) / b^2
    const double excess = (a / b - 1) * (a / b + 1);
    const double u = (excess + 1) * (x / a);
    const double v = y / b;
    double t = std::max(v, u - excess);
    for (int step = 0; step < kMostSteps; ++step) {
        const double p = u / (t + excess);
        const double q = v / t;
        const double value = p * p + q * q - 1;
        const double slope = -2 * (p * p / (t + excess) + q * q / t);
        const double next = t - value / slope;
        if (!(next > t)) break;
        t = next;
    }
    return Vec2((excess + 1) * x / (t + excess) - x, y / t - y).norm();
}

double signed_distance_of(const EllipseAxes& ellipse, const Vec2& p) {
    const Vec2 d = p - ellipse.centre;
    if (ellipse.a == ellipse.b) return d.norm() - ellipse.a;
    const double x = std::abs(d.dot(ellipse.along));
    const double y = std::abs(d.dot(turned_left(ellipse.along)));
    const double distance = distance_in_quadrant(ellipse.a, ellipse.b, x, y);
    const bool inside = Vec2(x / ellipse.a, y / ellipse.b).squaredNorm() < 1;
    return inside ? -distance : distance;
}

double signed_distance_of(const Polygon& polygon, const Vec2& p) {
    double distance = std::numeric_limits<double>::infinity();
    bool inside = false;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const Vec2& from = polygon[k];
        const Vec2& to = polygon[(k + 1) % polygon.size()];
        distance = std::min(distance, distance_to_segment(p, from, to));
        if ((from.y() > p.y()) == (to.y() > p.y())) continue;
        const bool is_left = cross(to - from, p - from) > 0;
        if (is_left == (to.y() > from.y())) inside = !inside;
    }
    return inside ? -distance : distance;
}

/// The linear map with the columns a e and b e', e the first axis.
Eigen::Matrix2d map_from_disc(const EllipseAxes& ellipse) {
    Eigen::Matrix2d map;
    map << ellipse.a * ellipse.along, ellipse.b * turned_left(ellipse.along);
    return map;
}

Vec2 to_disc(const EllipseAxes& ellipse, const Vec2& d) {
    return {d.dot(ellipse.along) / ellipse.a, d.dot(turned_left(ellipse.along)) / ellipse.b};
}

/// The ellipse that a linear map makes of the unit disc.
EllipseAxes image_of_disc(const Eigen::Matrix2d& map, const Vec2& centre) {
    const Eigen::Matrix2d square = map * map.transpose();
    const double mean = (square(0, 0) + square(1, 1)) / 2;
    const double half = (square(0, 0) - square(1, 1)) / 2;
    const double root = Vec2(half, square(0, 1)).norm();
    const double a = std::sqrt(mean + root);
    Vec2 along = half > 0 ? Vec2(half + root, square(0, 1)) : Vec2(square(0, 1), root - half);
    along = root > 0 ? Vec2(along.normalized()) : Vec2(1, 0);
    return {centre, along, a, std::min(a, std::abs(cross(map.col(0), map.col(1))) / a)};
}

/// How the unit disc lies to a curve at this signed distance from its centre; kMeet also where the
/// curve is inside.
ShapeRelation relation_of_disc(double distance) {
    if (distance > 1 + kTouching) return ShapeRelation::kApart;
    return distance < -1 - kTouching ? ShapeRelation::kFirstInside : ShapeRelation::kMeet;
}

/// After mapping the first ellipse to the unit disc.
ShapeRelation relation_in_disc(const EllipseAxes& first, const EllipseAxes& second) {
    Eigen::Matrix2d map = map_from_disc(second);
    map.col(0) = to_disc(first, map.col(0));
    map.col(1) = to_disc(first, map.col(1));
    const EllipseAxes image = image_of_disc(map, to_disc(first, second.centre - first.centre));
    return relation_of_disc(signed_distance_of(image, Vec2(0, 0)));
}

ShapeRelation exchanged(ShapeRelation relation) {
    if (relation == ShapeRelation::kFirstInside) return ShapeRelation::kSecondInside;
    return relation == ShapeRelation::kSecondInside ? ShapeRelation::kFirstInside : relation;
}

ShapeRelation relation(const EllipseAxes& first, const EllipseAxes& second) {
    const ShapeRelation found = relation_in_disc(first, second);
    if (found != ShapeRelation::kMeet) return found;
    const ShapeRelation other = relation_in_disc(second, first);
    return other == ShapeRelation::kFirstInside ? ShapeRelation::kSecondInside : found;
}

ShapeRelation relation(const EllipseAxes& ellipse, const Polygon& polygon) {
    Polygon image;
    double farthest = 0;
    for (const Vec2& corner : polygon) {
        image.push_back(to_disc(ellipse, corner - ellipse.centre));
        farthest = std::max(farthest, image.back().norm());
    }
    if (farthest < 1 - kTouching) return ShapeRelation::kSecondInside;
    return relation_of_disc(signed_distance_of(image, Vec2(0, 0)));
}

ShapeRelation relation(const Polygon& polygon, const EllipseAxes& ellipse) {
    return exchanged(relation(ellipse, polygon));
}

ShapeRelation relation(const Polygon& first, const Polygon& second) {
    return PolygonSides(first).relation(PolygonSides(second), Vec2(0, 0));
}

/// Calls the function with the shape as EllipseAxes or as Polygon.
template <class Function>
auto with_kind(const Shape& shape, const Function& function) {
    return std::visit(Overloaded{[&](const Polygon& polygon) { return function(polygon); },
                                 [&](const auto& round) { return function(ellipse_axes(round)); }},
                      shape);
}

EllipseAxes translated(EllipseAxes ellipse, const Vec2& translation) {
    ellipse.centre += translation;
    return ellipse;
}
Polygon translated(Polygon polygon, const Vec2& translation) {
    for (Vec2& corner : polygon) corner += translation;
    return polygon;
}

}  // namespace

Vec2 EllipseAxes::at_degrees(double t) const {
    const CosSin angle = cos_sin_of_degrees(t);
    return centre + a * angle.cos * along + b * angle.sin * turned_left(along);
}

EllipseAxes ellipse_axes(const Circle& circle) {
    return {circle.centre, {1, 0}, circle.radius, circle.radius};
}

EllipseAxes ellipse_axes(const Ellipse& ellipse) {
    const CosSin angle = cos_sin_of_degrees(ellipse.degrees);
    const Vec2 along(angle.cos, angle.sin);
    if (ellipse.a >= ellipse.b) return {ellipse.centre, along, ellipse.a, ellipse.b};
    return {ellipse.centre, turned_left(along), ellipse.b, ellipse.a};
}

std::vector<Inclusion> circular_inclusions(const std::vector<Circle>& circles, int tag) {
    std::vector<Inclusion> inclusions;
    for (const Circle& circle : circles) {
        Inclusion inclusion;
        inclusion.shape = circle;
        inclusion.tag = tag;
        inclusion.line = static_cast<int>(inclusions.size()) + 1;
        inclusions.push_back(std::move(inclusion));
    }
    return inclusions;
}

double shape_area(const Shape& shape) {
    return std::visit(
        Overloaded{[](const Polygon& polygon) { return std::abs(polygon_area(polygon)); },
                   [](const auto& round) {
                       const EllipseAxes axes = ellipse_axes(round);
                       return std::numbers::pi * axes.a * axes.b;
                   }},
        shape);
}

double signed_distance(const Shape& shape, const Vec2& p) {
    return with_kind(shape, [&](const auto& kind) { return signed_distance_of(kind, p); });
}

ShapeRelation shape_relation(const Shape& first, const Shape& second, const Vec2& translation) {
    return with_kind(first, [&](const auto& one) {
        return with_kind(second, [&](const auto& other) {
            return relation(one, translated(other, translation));
        });
    });
}

Shape mirrored(const Shape& shape, Walls walls, int r) {
    const auto image = [&](const Vec2& p) { return mirror_image(p, walls, r); };
    return std::visit(
        Overloaded{[&](const Circle& circle) -> Shape {
                       return Circle{image(circle.centre), circle.radius};
                   },
                   [&](const Ellipse& ellipse) -> Shape {
                       // The reflection of an axis at x or at y has the opposite angle, up to 180
                       // degrees.
                       const double degrees = is_reflection(r) ? -ellipse.degrees : ellipse.degrees;
                       return Ellipse{image(ellipse.centre), ellipse.a, ellipse.b, degrees};
                   },
                   [&](const Polygon& polygon) -> Shape {
                       Polygon corners;
                       for (const Vec2& corner : polygon) corners.push_back(image(corner));
                       if (is_reflection(r)) std::reverse(corners.begin(), corners.end());
                       return corners;
                   }},
        shape);
}

Shape translated(const Shape& shape, const Vec2& translation) {
    return std::visit(Overloaded{[&](const Polygon& polygon) -> Shape {
                                     return translated(polygon, translation);
                                 },
                                 [&](auto round) -> Shape {
                                     round.centre += translation;
                                     return round;
                                 }},
                      shape);
}

std::array<double, 2> extent(const Shape& shape, int axis) {
    return std::visit(
        Overloaded{[axis](const Polygon& polygon) -> std::array<double, 2> {
                       double low = polygon[0][axis];
                       double high = low;
                       for (const Vec2& corner : polygon) {
                           low = std::min(low, corner[axis]);
                           high = std::max(high, corner[axis]);
                       }
                       return {low, high};
                   },
                   [axis](const auto& round) -> std::array<double, 2> {
                       const EllipseAxes axes = ellipse_axes(round);
                       const Vec2 half(axes.a * axes.along[axis], axes.b * axes.along[1 - axis]);
                       return {axes.centre[axis] - half.norm(), axes.centre[axis] + half.norm()};
                   }},
        shape);
}

Circle bounding_circle(const Shape& shape) {
    return std::visit(Overloaded{[](const Polygon& polygon) {
                                     Vec2 least = polygon[0];
                                     Vec2 most = polygon[0];
                                     for (const Vec2& corner : polygon) {
                                         least = least.cwiseMin(corner);
                                         most = most.cwiseMax(corner);
                                     }
                                     return Circle{(least + most) / 2, (most - least).norm() / 2};
                                 },
                                 [](const auto& round) {
                                     const EllipseAxes axes = ellipse_axes(round);
                                     return Circle{axes.centre, axes.a};
                                 }},
                      shape);
}

}  // namespace pcvt::plane
