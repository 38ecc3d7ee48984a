#include "mesher/space/space_sites.hpp"

#include <gtest/gtest.h>

#include "mesher/base/error.hpp"
#include "tests/support/space_lattices.hpp"

namespace pcvt {
namespace {

TEST(SpaceSites, AreWrappedMultiplesOfTheGrid) {
    for (const auto& [name, lattice] : testing::space_lattices()) {
        SCOPED_TRACE(name);
        Points3 points = uniform_points(lattice, 50, 1);
        points.colwise() += lattice.translation({3, -2, 7});
        const SpaceSites sites(lattice, points);
        const Points3& u = sites.coordinates();
        EXPECT_GE(u.minCoeff(), 0);
        EXPECT_LT(u.maxCoeff(), 1);
        EXPECT_TRUE((u * kGrid3).cwiseEqual((u * kGrid3).array().floor().matrix()).all());
        for (SiteId s = 0; s < 50; ++s) {
            const Vec3 away = lattice.to_lattice(sites.position(s) - points.col(s));
            EXPECT_LT((away - Vec3(away.array().round())).norm(), 1e-12);
        }
    }
}

TEST(SpaceSites, NameTheFirstDuplicates) {
    const SpaceLattice cube = SpaceLattice::box(1, 1, 1);
    Points3 points = uniform_points(cube, 8, 1);
    points.col(6) = points.col(2) + Vec3(1, -3, 0);
    try {
        const SpaceSites sites(cube, points);
        FAIL();
    } catch (const DuplicateSites& error) {
        EXPECT_EQ(error.first(), 2);
        EXPECT_EQ(error.second(), 6);
    }
}

TEST(SpaceSites, RejectBadPoints) {
    const SpaceLattice cube = SpaceLattice::box(1, 1, 1);
    EXPECT_THROW(SpaceSites(cube, Points3(3, 0)), InvalidInput);
    EXPECT_THROW(SpaceSites(cube, Points3::Constant(3, 1, 1e10)), InvalidInput);
    EXPECT_THROW(SpaceSites(cube, Points3::Constant(3, 1, std::nan(""))), InvalidInput);
    EXPECT_THROW(uniform_points(cube, 0, 1), InvalidInput);
}

TEST(SpaceSites, SpacingIsTheCubeRootOfTheVolumeOfACell) {
    const SpaceLattice box = SpaceLattice::box(1, 2, 4);
    EXPECT_NEAR(SpaceSites(box, uniform_points(box, 8, 1)).spacing(), 1, 1e-15);
}

TEST(UniformPoints, FillTheDomainAndRepeat) {
    const SpaceLattice cube = SpaceLattice::box(1, 1, 1);
    const Points3 points = uniform_points(cube, 4000, 5);
    EXPECT_LT((points.rowwise().mean() - Vec3::Constant(0.5)).norm(), 0.02);
    EXPECT_EQ(points, uniform_points(cube, 4000, 5));
    EXPECT_NE(points, uniform_points(cube, 4000, 6));
}

}  // namespace
}  // namespace pcvt
