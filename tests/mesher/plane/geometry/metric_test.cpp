#include "mesher/plane/geometry/metric.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "mesher/base/error.hpp"
#include "mesher/plane/geometry/sites.hpp"
#include "tests/support/lattices.hpp"

namespace pcvt::plane {
namespace {

TEST(Metric, MapsBackAndForthWithoutChangingAreas) {
    for (const auto& [name, lattice] : testing::lattices()) {
        for (const double ratio : {0.2, 1.0, 1.5, 3.0, 100.0}) {
            for (const double degrees : {0.0, 30.0, -90.0, 137.0, 720.0}) {
                const Metric metric(ratio, degrees);
                const Lattice round = metric.to_round(lattice);
                EXPECT_NEAR(round.area(), lattice.area(), 1e-11 * lattice.area());
                EXPECT_EQ(round.right_handed(), lattice.right_handed());
                const Vec2 p = lattice.to_position({0.3, 0.8});
                const Vec2 there = metric.to_round(p);
                EXPECT_LT((metric.from_round(there) - p).norm(), 1e-13 * p.norm());
                EXPECT_LT((round.to_lattice(there) - Vec2(0.3, 0.8)).norm(), 1e-10);
            }
        }
    }
}

// Law 2.
TEST(Metric, CellsAreLongAlongTheDirection) {
    const Metric metric(4, 30);
    const double angle = 30 * std::numbers::pi / 180;
    const Vec2 along(std::cos(angle), std::sin(angle));
    EXPECT_NEAR(metric.to_round(along).norm(), 0.5, 1e-15);
    EXPECT_NEAR(metric.to_round(Vec2(-along.y(), along.x())).norm(), 2, 1e-15);
    EXPECT_EQ(Metric(4, 0).to_round(Vec2(1, 1)), Vec2(0.5, 2));
    EXPECT_EQ(Metric(4, 90).to_round(Vec2(1, 1)), Vec2(2, 0.5));
    EXPECT_EQ(Metric(0.25, -180).to_round(Vec2(1, 1)), Vec2(2, 0.5));
}

TEST(Metric, ItsNumbersMakeTheSameMetric) {
    for (const double ratio : {0.01, 1.0 / 3, 1.0, 2.5, 100.0}) {
        for (const double degrees : {-77.25, 0.0, 30.0, 1.0 / 3, 405.0}) {
            const Metric metric(ratio, degrees);
            const Metric again(metric.ratio(), metric.degrees());
            EXPECT_EQ(again, metric);
            EXPECT_EQ(again.to_round(Vec2(0.1, 0.7)), metric.to_round(Vec2(0.1, 0.7)));
            EXPECT_EQ(again.from_round(Vec2(0.1, 0.7)), metric.from_round(Vec2(0.1, 0.7)));
            double longest = 0;
            for (int k = 0; k < 360; ++k) {
                const double angle = k * std::numbers::pi / 180 + degrees * std::numbers::pi / 180;
                longest = std::max(longest,
                                   metric.to_round(Vec2(std::cos(angle), std::sin(angle))).norm());
            }
            EXPECT_NEAR(metric.largest_stretch(), longest, 1e-12 * longest);
        }
    }
    EXPECT_EQ(Metric(1, 33), Metric());
    EXPECT_FALSE(Metric(3, 30) == Metric(3, 31));
    EXPECT_FALSE(Metric(3, 30) == Metric(2, 30));
}

TEST(Metric, RatioOneChangesNoBit) {
    const Lattice lattice({1, 0.1}, {0.37, 0.81});
    const Points points = uniform_points(lattice, 10, 1);
    EXPECT_EQ(Metric(1, 33).to_round(points), points);
    EXPECT_EQ(Metric(1, 33).to_round(lattice).b(), lattice.b());
    EXPECT_TRUE(Metric().is_round());
}

TEST(Metric, RefusesRatiosThatAreNotPositive) {
    for (const double ratio : {0.0, -2.0, 101.0, std::numeric_limits<double>::quiet_NaN()}) {
        EXPECT_THROW(Metric(ratio, 0), InvalidInput) << ratio;
    }
    EXPECT_THROW(Metric(2, std::numeric_limits<double>::infinity()), InvalidInput);
}

}  // namespace
}  // namespace pcvt::plane
