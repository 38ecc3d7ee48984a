#include "mesher/space/geometry/sites.hpp"

#include <gtest/gtest.h>

#include "mesher/base/error.hpp"
#include "tests/support/space_lattices.hpp"

namespace pcvt::space {
namespace {

TEST(Sites, AreWrappedMultiplesOfTheGrid) {
    for (const auto& [name, lattice] : testing::space_lattices()) {
        SCOPED_TRACE(name);
        Points points = uniform_points(lattice, 50, 1);
        points.colwise() += lattice.translation({3, -2, 7});
        const Sites sites(lattice, points);
        const Points& u = sites.coordinates();
        EXPECT_GE(u.minCoeff(), 0);
        EXPECT_LT(u.maxCoeff(), 1);
        EXPECT_TRUE((u * kGrid).cwiseEqual((u * kGrid).array().floor().matrix()).all());
        for (SiteId s = 0; s < 50; ++s) {
            const Vec3 away = lattice.to_lattice(sites.position(s) - points.col(s));
            EXPECT_LT((away - Vec3(away.array().round())).norm(), 1e-12);
        }
    }
}

TEST(Sites, NameTheFirstDuplicates) {
    const Lattice cube = Lattice::box(1, 1, 1);
    Points points = uniform_points(cube, 8, 1);
    points.col(6) = points.col(2) + Vec3(1, -3, 0);
    try {
        const Sites sites(cube, points);
        FAIL();
    } catch (const DuplicateSites& error) {
        EXPECT_EQ(error.first(), 2);
        EXPECT_EQ(error.second(), 6);
    }
}

TEST(Sites, RejectBadPoints) {
    const Lattice cube = Lattice::box(1, 1, 1);
    EXPECT_THROW(Sites(cube, Points(3, 0)), InvalidInput);
    EXPECT_THROW(Sites(cube, Points::Constant(3, 1, 1e10)), InvalidInput);
    EXPECT_THROW(Sites(cube, Points::Constant(3, 1, std::nan(""))), InvalidInput);
    EXPECT_THROW(uniform_points(cube, 0, 1), InvalidInput);
}

TEST(Sites, SpacingIsTheCubeRootOfTheVolumeOfACell) {
    const Lattice box = Lattice::box(1, 2, 4);
    EXPECT_NEAR(Sites(box, uniform_points(box, 8, 1)).spacing(), 1, 1e-15);
}

TEST(UniformPoints, FillTheDomainAndRepeat) {
    const Lattice cube = Lattice::box(1, 1, 1);
    const Points points = uniform_points(cube, 4000, 5);
    EXPECT_LT((points.rowwise().mean() - Vec3::Constant(0.5)).norm(), 0.02);
    EXPECT_EQ(points, uniform_points(cube, 4000, 5));
    EXPECT_NE(points, uniform_points(cube, 4000, 6));
}

}  // namespace
}  // namespace pcvt::space
