#include "io/forms/triangle_fan.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

namespace pcvt {
namespace {

using ::testing::IsEmpty;
using ::testing::SizeIs;

double area(const Point32& p, const Point32& q, const Point32& r) {
    return ((double(q[0]) - p[0]) * (double(r[1]) - p[1]) -
            (double(q[1]) - p[1]) * (double(r[0]) - p[0])) /
           2;
}

std::vector<double> areas(const std::vector<Point32>& corners) {
    std::vector<double> result;
    for (const auto& [a, b, c] : triangle_fan(corners)) {
        result.push_back(area(corners.at(a), corners.at(b), corners.at(c)));
    }
    return result;
}

double sum(const std::vector<double>& numbers) {
    return std::accumulate(numbers.begin(), numbers.end(), 0.0);
}

/// Corners on an ellipse at random angles.
std::vector<Point32> random_convex(std::mt19937_64& random) {
    std::vector<double> angles(3 + random() % 7);
    std::uniform_real_distribution<double> angle(0, 2 * M_PI);
    for (double& value : angles) value = angle(random);
    std::sort(angles.begin(), angles.end());
    std::vector<Point32> corners;
    for (const double t : angles) corners.push_back({float(3 * std::cos(t)), float(std::sin(t))});
    return corners;
}

TEST(TriangleFan, CoversAConvexPolygonOnce) {
    std::mt19937_64 random(1);
    for (int round = 0; round < 1000; ++round) {
        const std::vector<Point32> corners = random_convex(random);
        double expected = 0;
        for (std::size_t k = 1; k + 1 < corners.size(); ++k) {
            expected += area(corners[0], corners[k], corners[k + 1]);
        }
        const std::vector<double> fan = areas(corners);
        EXPECT_THAT(fan, SizeIs(corners.size() - 2));
        EXPECT_GT(*std::min_element(fan.begin(), fan.end()), 0);
        EXPECT_NEAR(sum(fan), expected, 1e-12);
    }
}

TEST(TriangleFan, ACornerOnAnEdgeGivesNoFlatTriangle) {
    const std::vector<Point32> corners{{0, 0}, {0.5F, 0}, {1, 0}, {1, 1}, {0, 1}};
    EXPECT_THAT(areas(corners), SizeIs(3));
    EXPECT_DOUBLE_EQ(sum(areas(corners)), 1);
}

TEST(TriangleFan, TrianglesOfCollapsedEdgesAreLeftOut) {
    const std::vector<Point32> corners{{0, 0}, {1, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 1}};
    EXPECT_THAT(areas(corners), SizeIs(2));
    EXPECT_DOUBLE_EQ(sum(areas(corners)), 1);
}

TEST(TriangleFan, ShortEdgesDoNotSpoilTheChoice) {
    // The first corner is the furthest from the short edge, but it would make a flat triangle of
    // the first three.
    const float step = 1e-6F;
    const std::vector<Point32> corners{{0, -0.1F}, {0.5F, -0.0501F}, {1, 0},
                                       {1, 1},     {1 - step, 1},    {0, 1}};
    std::vector<double> fan = areas(corners);
    ASSERT_THAT(fan, SizeIs(4));
    std::sort(fan.begin(), fan.end());
    EXPECT_GT(fan[0], 0);
    EXPECT_GT(fan[1], 0.01);
}

TEST(TriangleFan, APolygonWithoutAreaGivesNoTriangles) {
    EXPECT_THAT(areas({{0, 0}, {1, 0}, {2, 0}, {3, 0}}), IsEmpty());
    EXPECT_THAT(areas({{5, 5}, {5, 5}, {5, 5}}), IsEmpty());
}

}  // namespace
}  // namespace pcvt
