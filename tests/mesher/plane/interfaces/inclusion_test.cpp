#include "mesher/plane/interfaces/inclusion.hpp"

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <map>

#include "tests/support/random_inclusions.hpp"

namespace pcvt::plane {
namespace {

double uniform(std::mt19937_64& random, double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
}

double distance_to(const Polygon& points, const Vec2& p) {
    double least = std::numeric_limits<double>::infinity();
    for (const Vec2& q : points) least = std::min(least, (q - p).norm());
    return least;
}

/// The winding number of a dense polygon, which is not 0 inside.
bool winds_round(const Polygon& points, const Vec2& p) {
    double turn = 0;
    for (std::size_t k = 0; k < points.size(); ++k) {
        const Vec2 d = points[k] - p;
        const Vec2 e = points[(k + 1) % points.size()] - p;
        turn += std::atan2(cross(d, e), d.dot(e));
    }
    return std::abs(turn) > 1;
}

TEST(Inclusion, DistancesAreThoseOfPointsOnTheCurve) {
    std::mt19937_64 random(1);
    for (int k = 0; k < 60; ++k) {
        const Shape shape = testing::random_shape({0.3, -2}, uniform(random, 0.1, 3), random);
        const Polygon points = testing::points_on(shape, 3000);
        const double size = bounding_circle(shape).radius;
        for (int m = 0; m < 20; ++m) {
            const Vec2 p =
                Vec2(0.3, -2) + 1.5 * size * Vec2(uniform(random, -1, 1), uniform(random, -1, 1));
            const double distance = distance_to(points, p);
            EXPECT_NEAR(std::abs(signed_distance(shape, p)), distance, 2e-3 * size);
            if (distance < 2e-3 * size) continue;
            EXPECT_EQ(signed_distance(shape, p) < 0, winds_round(points, p));
        }
    }
}

TEST(Inclusion, DistancesFromTheAxesOfAnEllipseAreExact) {
    const Ellipse ellipse{{0, 0}, 4, 1, 0};
    EXPECT_DOUBLE_EQ(signed_distance(ellipse, {5, 0}), 1);
    EXPECT_DOUBLE_EQ(signed_distance(ellipse, {0, 3}), 2);
    EXPECT_DOUBLE_EQ(signed_distance(ellipse, {0, 0.25}), -0.75);
    EXPECT_DOUBLE_EQ(signed_distance(ellipse, {0, 0}), -1);
    EXPECT_DOUBLE_EQ(signed_distance(ellipse, {4, 0}), 0);
    // The foot of a point between the centres of curvature is (a^2 x / (a^2 - b^2), y).
    EXPECT_NEAR(signed_distance(ellipse, {1.5, 0}), -std::sqrt(0.01 + 1 - 0.16), 1e-15);
    EXPECT_NEAR(signed_distance(ellipse, {1.5, 1e-300}), -std::sqrt(0.01 + 1 - 0.16), 1e-9);
}

TEST(Inclusion, AxesOfAnEllipseMayBeGivenInEitherOrder) {
    const Ellipse first{{1, 2}, 3, 0.5, 20};
    const Ellipse second{{1, 2}, 0.5, 3, -70};
    for (double x = -3; x < 5; x += 0.7) {
        EXPECT_NEAR(signed_distance(first, {x, 1.1}), signed_distance(second, {x, 1.1}), 1e-14);
    }
}

TEST(Inclusion, AreasAreThoseOfDensePolygons) {
    std::mt19937_64 random(2);
    for (int k = 0; k < 30; ++k) {
        const Shape shape = testing::random_shape({5, 5}, uniform(random, 0.1, 3), random);
        const double area = polygon_area(testing::points_on(shape, 4000));
        EXPECT_NEAR(shape_area(shape), area, 1e-6 * area);
    }
}

// The twin compares dense points of the curves.
/// The least and the largest signed distance of points of a curve from another shape.
std::array<double, 2> distances(const Shape& shape, const Polygon& points, const Vec2& moved) {
    std::array<double, 2> found{std::numeric_limits<double>::infinity(), -1e300};
    for (const Vec2& p : points) {
        const double distance = signed_distance(shape, p + moved);
        found = {std::min(found[0], distance), std::max(found[1], distance)};
    }
    return found;
}

TEST(Inclusion, RelationsAreThoseOfPointsOnTheCurves) {
    std::mt19937_64 random(3);
    std::map<ShapeRelation, int> counts;
    for (int k = 0; k < 1500; ++k) {
        const double size = k % 2 == 0 ? 1 : 0.3;
        const Shape first = testing::random_shape({0, 0}, size * uniform(random, 0.3, 1), random);
        const Shape second = testing::random_shape({1, 1}, uniform(random, 0.3, 1), random);
        const Vec2 moved(uniform(random, -2, 0.5), uniform(random, -2, 0.5));
        const auto [low, high] = distances(first, testing::points_on(second, 200), moved);
        const auto [least, most] = distances(second, testing::points_on(first, 200), -moved);
        const ShapeRelation relation = shape_relation(first, second, moved);
        ++counts[relation];
        // Exchanged shapes are in the opposite relation.
        const ShapeRelation other = shape_relation(second, first, -moved);
        EXPECT_EQ(relation == ShapeRelation::kFirstInside, other == ShapeRelation::kSecondInside);
        EXPECT_EQ(relation == ShapeRelation::kApart, other == ShapeRelation::kApart);
        const double nearest =
            std::min({std::abs(low), std::abs(high), std::abs(least), std::abs(most)});
        if (nearest < 1e-3) continue;
        const ShapeRelation expected = high < 0                   ? ShapeRelation::kSecondInside
                                       : most < 0                 ? ShapeRelation::kFirstInside
                                       : std::min(low, least) < 0 ? ShapeRelation::kMeet
                                                                  : ShapeRelation::kApart;
        EXPECT_EQ(relation, expected) << k;
    }
    for (const ShapeRelation relation :
         {ShapeRelation::kApart, ShapeRelation::kMeet, ShapeRelation::kFirstInside}) {
        EXPECT_GT(counts[relation], 30);
    }
}

TEST(Inclusion, TouchingShapesMeet) {
    const Circle circle{{0, 0}, 1};
    const auto relation = [&](const Shape& second, const Vec2& moved = {0, 0}) {
        return shape_relation(circle, second, moved);
    };
    EXPECT_EQ(relation(Circle{{3, 0}, 2}), ShapeRelation::kMeet);
    EXPECT_EQ(relation(Circle{{3, 0}, 2}, {1e-6, 0}), ShapeRelation::kApart);
    EXPECT_EQ(relation(Polygon{{1, -1}, {2, 0}, {1, 1}}), ShapeRelation::kMeet);
    EXPECT_EQ(relation(Circle{{0.1, 0}, 0.2}), ShapeRelation::kSecondInside);
    EXPECT_EQ(relation(Circle{{0.8, 0}, 0.2}), ShapeRelation::kMeet);
    EXPECT_EQ(relation(Circle{{0.8, 0}, 0.2}, {-1e-6, 0}), ShapeRelation::kSecondInside);
    EXPECT_EQ(relation(circle), ShapeRelation::kMeet);
    EXPECT_EQ(relation(Circle{{0, 0}, 1.001}), ShapeRelation::kFirstInside);
    EXPECT_EQ(
        shape_relation(Polygon{{0, 0}, {1, 0}, {0, 1}}, Polygon{{1, 0}, {2, 0}, {2, 1}}, {0, 0}),
        ShapeRelation::kMeet);
}

}  // namespace
}  // namespace pcvt::plane
