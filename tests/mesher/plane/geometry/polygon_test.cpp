#include "mesher/plane/geometry/polygon.hpp"

#include <gtest/gtest.h>

namespace pcvt::plane {
namespace {

const Polygon kTriangle = {{1, 1}, {4, 1}, {1, 3}};
const Polygon kBowTie = {{0, 0}, {1, 0}, {-0.5, 0.9}, {0, 1}};
/// A dart: simple, but not convex.
const Polygon kDart = {{0, 0}, {2, 0}, {0.5, 0.5}, {0, 2}};
/// Turns left at every corner, but twice in total.
const Polygon kPentagram = {{1, 0}, {-0.81, 0.59}, {0.31, -0.95}, {0.31, 0.95}, {-0.81, -0.59}};

TEST(Polygon, AreaPerimeterAndCentroidOfATriangle) {
    EXPECT_DOUBLE_EQ(polygon_area(kTriangle), 3);
    EXPECT_DOUBLE_EQ(polygon_perimeter(kTriangle), 5 + std::sqrt(13));
    EXPECT_DOUBLE_EQ(polygon_centroid(kTriangle).x(), 2);
    EXPECT_DOUBLE_EQ(polygon_centroid(kTriangle).y(), 5.0 / 3);
}

TEST(Polygon, AreaChangesSignWithTheDirection) {
    EXPECT_DOUBLE_EQ(polygon_area({kDart.rbegin(), kDart.rend()}), -polygon_area(kDart));
    EXPECT_DOUBLE_EQ(polygon_area(kDart), 1);
}

TEST(Polygon, CentroidOfADartIsTheMeanOverItsTwoTriangles) {
    const Vec2 expected = (Vec2(2.5, 0.5) / 3 + Vec2(0.5, 2.5) / 3) / 2;
    EXPECT_LT((polygon_centroid(kDart) - expected).norm(), 1e-15);
}

TEST(Polygon, ReflexDepthIsTheDistanceToTheChord) {
    EXPECT_EQ(reflex_depth(kTriangle), 0);
    EXPECT_DOUBLE_EQ(reflex_depth(kDart), (Vec2(1, 1) - Vec2(0.5, 0.5)).norm());
}

TEST(Polygon, ClippingKeepsOneSideOfALine) {
    EXPECT_DOUBLE_EQ(polygon_area(clipped(kTriangle, {1, 0}, 2.5)), 3 - 0.75);
    EXPECT_DOUBLE_EQ(polygon_area(clipped(kTriangle, {-1, 0}, -2.5)), 0.75);
    EXPECT_EQ(clipped(kTriangle, {1, 0}, 5), kTriangle);
    EXPECT_EQ(clipped(kTriangle, {1, 0}, 4), kTriangle);
    EXPECT_TRUE(clipped(kTriangle, {1, 0}, 0).empty());
}

TEST(Polygon, CrossingSidesAreFound) {
    EXPECT_TRUE(crosses_itself(kBowTie, 1e-12));
    EXPECT_TRUE(crosses_itself(kPentagram, 1e-12));
    EXPECT_FALSE(crosses_itself(kTriangle, 1e-12));
    EXPECT_FALSE(crosses_itself(kDart, 1e-12));
}

}  // namespace
}  // namespace pcvt::plane
