#include "mesher/space/cvt/minimum.hpp"

#include <gtest/gtest.h>

#include "mesher/space/cvt/cvt.hpp"
#include "tests/support/space_lattices.hpp"

namespace pcvt::space {
namespace {

using testing::kCube;

PeriodicDelaunay grid(int k) {
    Points points(3, k * k * k);
    for (int s = 0; s < points.cols(); ++s) {
        points.col(s) = Vec3(s % k, s / k % k, s / (k * k)) / k;
    }
    return periodic_delaunay(Sites(kCube, points));
}

TEST(SpaceMinimum, CubesAreSaddlesAndOneIsAMinimum) {
    EXPECT_EQ(decided_minimum(grid(1)), Minimum::kYes);
    EXPECT_EQ(decided_minimum(grid(2)), Minimum::kNo);
    EXPECT_EQ(decided_minimum(grid(4)), Minimum::kNo);
}

TEST(SpaceMinimum, OptimisedSitesEndAtMinima) {
    for (const int n : {2, 9, 30, 120}) {
        const auto result = compute_cvt(kCube, uniform_points(kCube, n, n), {{.tolerance = 1e-8}});
        EXPECT_EQ(decided_minimum(result.delaunay), Minimum::kYes) << n;
    }
}

TEST(SpaceMinimum, DoesNotDependOnTheUnit) {
    for (const double side : {1e-6, 1e6}) {
        const Lattice cube = Lattice::box(side, side, side);
        const auto result = compute_cvt(cube, uniform_points(cube, 20, 1), {});
        EXPECT_EQ(decided_minimum(result.delaunay), Minimum::kYes) << side;
    }
}

}  // namespace
}  // namespace pcvt::space
