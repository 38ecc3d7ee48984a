#include "mesher/space/geometry/metric.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "mesher/base/error.hpp"
#include "tests/support/space_lattices.hpp"

namespace pcvt::space {
namespace {

const std::vector<Vec3> kAxes{
    {1, 0, 0}, {0, 0, -2}, {1, 2, 3}, {-0.3, 1e-3, 0.7}, {3e200, 4e200, 0}};

TEST(MetricInSpace, Law1MapsBackAndForthWithoutChangingVolumes) {
    for (const auto& [name, lattice] : testing::space_lattices()) {
        for (const double ratio : {0.01, 0.2, 1.0, 3.0, 100.0}) {
            for (const Vec3& axis : kAxes) {
                const Metric metric(ratio, axis);
                const Lattice round = metric.to_round(lattice);
                EXPECT_NEAR(round.volume(), lattice.volume(), 1e-11 * lattice.volume()) << name;
                EXPECT_EQ(round.right_handed(), lattice.right_handed());
                const Vec3 p = lattice.to_position({0.3, 0.8, 0.1});
                EXPECT_LT((metric.from_round(metric.to_round(p)) - p).norm(), 1e-12 * p.norm());
            }
        }
    }
}

TEST(MetricInSpace, Law2BallsAreEllipsoids) {
    for (const double ratio : {0.1, 2.0, 10.0}) {
        for (const Vec3& axis : kAxes) {
            const Metric metric(ratio, axis);
            const Vec3 along = (axis / axis.cwiseAbs().maxCoeff()).normalized();
            const Vec3 across = along.unitOrthogonal();
            const double length = metric.from_round(along).norm();
            EXPECT_NEAR(length / metric.from_round(across).norm(), ratio, 1e-13 * ratio);
            EXPECT_NEAR(metric.from_round(along).dot(along), length, 1e-13 * length);
            EXPECT_NEAR(metric.largest_stretch_back(), std::max(length, length / ratio),
                        1e-13 * length * std::max(1.0, 1 / ratio));
            const double there = metric.to_round(along).norm();
            EXPECT_NEAR(metric.largest_stretch(), std::max(there, there * ratio),
                        1e-13 * there * std::max(1.0, ratio));
        }
    }
}

TEST(MetricInSpace, Law3TheRoundOneChangesNoBit) {
    const Vec3 p(0.1, 1.0 / 3, -7);
    const Metric round(1, {1, 2, 3});
    EXPECT_TRUE(round.is_round());
    EXPECT_EQ(round, Metric());
    EXPECT_EQ(round.to_round(p), p);
    EXPECT_EQ(round.from_round(p), p);
    EXPECT_EQ(round.to_round(testing::kCube).periods(), testing::kCube.periods());
    const Metric metric(2.5, {1, 2, 3});
    EXPECT_EQ(Metric(metric.ratio(), metric.axis()).to_round(p), metric.to_round(p));
}

TEST(MetricInSpace, SitesKeepTheirOrbits) {
    const Metric metric(7, {1, 1, 0});
    for (const auto& [name, lattice] : testing::space_lattices()) {
        const Points points = uniform_points(lattice, 20, 3);
        const Sites round(metric.to_round(lattice), metric.to_round(points));
        const Sites sites = metric.from_round(round, lattice);
        for (SiteId s = 0; s < 20; ++s) {
            const Vec3 u = lattice.to_lattice(sites.position(s) - Vec3(points.col(s)));
            EXPECT_LT((u.array() - u.array().round()).abs().maxCoeff(), 1e-12) << name;
        }
        const Offset offset{1, -2, 1};
        const Vec3 there = lattice.translation(sites.reduction().to_original(offset));
        EXPECT_LT((sites.reduction().reduced.translation(offset) - there).norm(),
                  1e-13 * there.norm());
    }
}

TEST(MetricInSpace, NeedsARatioAndADirection) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const double ratio : {0.0, -1.0, 0.009, 101.0, nan}) {
        EXPECT_THROW(Metric(ratio, {1, 0, 0}), InvalidInput) << ratio;
    }
    for (const Vec3& axis : {Vec3(0, 0, 0), Vec3(nan, 0, 0)}) {
        EXPECT_THROW(Metric(2, axis), InvalidInput);
        EXPECT_THROW(Metric(1, axis), InvalidInput);
    }
}

}  // namespace
}  // namespace pcvt::space
