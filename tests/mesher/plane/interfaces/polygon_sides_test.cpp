#include "mesher/plane/interfaces/polygon_sides.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "mesher/plane/interfaces/inclusion.hpp"
#include "tests/support/random_inclusions.hpp"

namespace pcvt::plane {
namespace {

double drawn(std::mt19937_64& random, double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
}

/// A star with a rough outline.
Polygon rough_star(int n, const Vec2& centre, std::mt19937_64& random) {
    Polygon polygon;
    for (int k = 0; k < n; ++k) {
        const double angle = 2 * std::numbers::pi * k / n;
        const double radius = drawn(random, 0.3, 1);
        polygon.push_back(centre + radius * Vec2(std::cos(angle), std::sin(angle)));
    }
    return polygon;
}

bool touch_by_brute_force(const Polygon& polygon) {
    const std::size_t n = polygon.size();
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = i + 2; j < n; ++j) {
            if (i == 0 && j + 1 == n) continue;
            const Polygon first{polygon[i], polygon[i + 1]};
            const Polygon second{polygon[j], polygon[(j + 1) % n]};
            if (testing::shapes_meet(first, second, Vec2(0, 0))) return true;
        }
    }
    return false;
}

TEST(PolygonSides, DistancesAreThoseOfTheInclusion) {
    std::mt19937_64 random(1);
    for (const int n : {3, 4, 5, 17, 100}) {
        const Polygon polygon = rough_star(n, {0.5, -1}, random);
        const PolygonSides sides(polygon);
        for (int k = 0; k < 300; ++k) {
            const Vec2 p(drawn(random, -1, 2), drawn(random, -2.5, 0.5));
            EXPECT_EQ(sides.signed_distance(p), signed_distance(Shape(polygon), p));
        }
        // Rays through corners count them once.
        for (const Vec2& corner : polygon) {
            const Vec2 p(drawn(random, -1, 2), corner.y());
            EXPECT_EQ(sides.signed_distance(p), signed_distance(Shape(polygon), p));
        }
    }
}

TEST(PolygonSides, TheLeastValueIsThatOfALoop) {
    std::mt19937_64 random(2);
    const PolygonSides sides(rough_star(60, {0, 0}, random));
    for (int k = 0; k < 200; ++k) {
        const Vec2 p(drawn(random, -1, 1), drawn(random, -1, 1));
        const auto value = [&](std::size_t m) {
            const double distance = distance_to_segment(p, sides.corner(m), sides.corner(m + 1));
            return distance * (1 + static_cast<double>(m % 7));
        };
        double least = 10;
        for (std::size_t m = 0; m < sides.size(); ++m) least = std::min(least, value(m));
        EXPECT_EQ(sides.least(p, 10, value), least);
        EXPECT_EQ(sides.least(p, least / 2, value), least / 2);
    }
}

TEST(PolygonSides, FindWhereTheyTouchThemselves) {
    std::mt19937_64 random(3);
    int n_touching = 0;
    for (int k = 0; k < 300; ++k) {
        Polygon polygon = rough_star(30, {0, 0}, random);
        // Exchanges of corners make some of them cross themselves.
        if (k % 2 == 0) std::swap(polygon[5], polygon[5 + static_cast<std::size_t>(k) % 20]);
        const bool touches = touch_by_brute_force(polygon);
        n_touching += touches;
        EXPECT_EQ(PolygonSides(polygon).touch_themselves(), touches);
    }
    EXPECT_GT(n_touching, 50);
    EXPECT_LT(n_touching, 250);
    // A corner on another side, and one near it.
    EXPECT_TRUE(PolygonSides({{0, 0}, {2, 0}, {2, 1}, {1, 0}, {0, 1}}).touch_themselves());
    EXPECT_TRUE(PolygonSides({{0, 0}, {2, 0}, {2, 1}, {1, 5e-10}, {0, 1}}).touch_themselves());
    EXPECT_FALSE(PolygonSides({{0, 0}, {2, 0}, {2, 1}, {1, 5e-9}, {0, 1}}).touch_themselves());
}

TEST(PolygonSides, MeetOtherPolygons) {
    std::mt19937_64 random(4);
    const PolygonSides star(rough_star(40, {0, 0}, random));
    const PolygonSides small({{-0.1, -0.1}, {0.1, -0.1}, {0.1, 0.1}, {-0.1, 0.1}});
    EXPECT_EQ(star.relation(small, {0, 0}), ShapeRelation::kSecondInside);
    EXPECT_EQ(small.relation(star, {0, 0}), ShapeRelation::kFirstInside);
    EXPECT_EQ(star.relation(small, {1.2, 0}), ShapeRelation::kApart);
    EXPECT_EQ(small.relation(small, {0, 0}), ShapeRelation::kMeet);
    // A cross, of which no corner lies in the other polygon.
    const PolygonSides wide({{-1, -0.1}, {1, -0.1}, {1, 0.1}, {-1, 0.1}});
    const PolygonSides tall({{-0.1, -1}, {0.1, -1}, {0.1, 1}, {-0.1, 1}});
    EXPECT_EQ(wide.relation(tall, {0, 0}), ShapeRelation::kMeet);
    EXPECT_EQ(wide.relation(tall, {1.2, 0}), ShapeRelation::kApart);
    // All corners of one lie in a bent one, whose corner lies between them.
    const PolygonSides bent({{-1, -1}, {0, 0.5}, {1, -1}, {1, 1}, {-1, 1}});
    const PolygonSides bar({{-0.9, -0.5}, {0.9, -0.5}, {0.9, 0.8}, {-0.9, 0.8}});
    EXPECT_EQ(bent.relation(bar, {0, 0}), ShapeRelation::kMeet);
}

TEST(PolygonSides, OfAMeasuredOutlineTakeNoQuadraticTime) {
    std::mt19937_64 random(5);
    Polygon polygon;
    for (int k = 0; k < 300'000; ++k) {
        const double angle = 2 * std::numbers::pi * k / 300'000;
        polygon.push_back(Vec2(std::cos(angle), std::sin(angle)) * drawn(random, 1, 1.000001));
    }
    const PolygonSides sides(polygon);
    EXPECT_FALSE(sides.touch_themselves());
    EXPECT_EQ(sides.relation(PolygonSides(polygon), {0.1, 0}), ShapeRelation::kMeet);
}

}  // namespace
}  // namespace pcvt::plane
