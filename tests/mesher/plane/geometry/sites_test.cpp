#include "mesher/plane/geometry/sites.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "mesher/base/error.hpp"
#include "tests/support/lattices.hpp"

namespace pcvt::plane {
namespace {

using testing::lattices;

Points points(std::initializer_list<Vec2> list) {
    Points result(2, static_cast<Eigen::Index>(list.size()));
    Eigen::Index k = 0;
    for (const Vec2& p : list) result.col(k++) = p;
    return result;
}

TEST(Sites, PositionsAreThePointsModuloTheLattice) {
    for (const auto& [name, lattice] : lattices()) {
        const Points given = uniform_points(lattice, 50, 3).colwise() + 2 * lattice.a();
        const Sites sites(lattice, given);
        const Lattice& reduced = sites.reduction().reduced;
        const double size = lattice.a().norm() + lattice.b().norm();
        for (SiteId s = 0; s < sites.n_sites(); ++s) {
            const Vec2 difference = given.col(s) - sites.position(s);
            const Vec2 periods = reduced.to_lattice(difference).array().round();
            EXPECT_LT((difference - reduced.to_position(periods)).norm(), 1e-14 * size) << name;
            EXPECT_GE(sites.coordinates().col(s).minCoeff(), 0) << name;
            EXPECT_LT(sites.coordinates().col(s).maxCoeff(), 1) << name;
        }
    }
}

TEST(Sites, AcceptsNegativeZeroAndTheFarSideOfTheSeam) {
    const Sites sites(Lattice::rectangle(1, 1), points({{-0.0, 1.0}, {0.5, -1e-17}}));
    EXPECT_EQ(sites.coordinates().col(0), Vec2(0, 0));
    EXPECT_EQ(sites.coordinates().col(1), Vec2(0.5, 0));
}

TEST(Sites, NamesTheFirstTwoDuplicatesModuloTheLattice) {
    const Lattice skewed({1, 0}, {7, 1});
    const Vec2 p(0.25, 0.5);
    try {
        Sites(skewed, points({{0.1, 0.1}, p, {0.2, 0.2}, p + skewed.translation({-3, 2}), p}));
        FAIL() << "duplicates were accepted";
    } catch (const DuplicateSites& error) {
        EXPECT_EQ(error.first(), 1);
        EXPECT_EQ(error.second(), 3);
    }
}

TEST(Sites, RejectsPointsThatCannotBeWrapped) {
    const Lattice unit = Lattice::rectangle(1, 1);
    EXPECT_THROW(Sites(unit, Points(2, 0)), InvalidInput);
    EXPECT_THROW(Sites(unit, points({{0, std::nan("")}})), InvalidInput);
    EXPECT_THROW(Sites(unit, points({{std::numeric_limits<double>::infinity(), 0}})), InvalidInput);
    EXPECT_THROW(Sites(unit, points({{1e10, 0}})), InvalidInput);
}

TEST(Sites, FromCoordinatesAreWrappedExactly) {
    const Lattice lattice({1, 0}, {7, 1});
    const double ulp = 0x1p-51;
    const Sites sites(lattice, reduce(lattice),
                      points({{-ulp, 1}, {1.25 + ulp, -0.75}, {0, 2 - ulp}}));
    EXPECT_EQ(sites.coordinates(), points({{1 - ulp, 0}, {0.25 + ulp, 0.25}, {0, 1 - ulp}}));
    EXPECT_EQ(sites.reduction().reduced.b().norm(), 1);
}

TEST(Sites, FromCoordinatesMayCoincideAndReportIt) {
    const Lattice unit = Lattice::rectangle(1, 1);
    const auto duplicates = [&](std::initializer_list<Vec2> list) {
        return Sites(unit, reduce(unit), points(list)).duplicates();
    };
    using Ids = std::pair<SiteId, SiteId>;
    EXPECT_EQ(duplicates({{0.5, 0.5}, {0.5, 0.5 + 0x1p-51}, {0.25, 0.5}}), Ids(-1, -1));
    EXPECT_EQ(duplicates({{0.5, 0.5}, {0.25, 0.5}, {1.25, -0.5}, {0.5, 0.5}}), Ids(0, 3));
    EXPECT_EQ(duplicates({{0.5, 0.1}, {0.5, 0.7}, {0.5, 0.1}}), Ids(0, 2));
}

TEST(UniformPoints, DependOnTheSeedAlone) {
    const Lattice lattice({1, 0}, {7, 1});
    EXPECT_EQ(uniform_points(lattice, 20, 5), uniform_points(lattice, 20, 5));
    EXPECT_NE(uniform_points(lattice, 20, 5), uniform_points(lattice, 20, 6));
    EXPECT_EQ(uniform_points(lattice, 20, 5).leftCols(7), uniform_points(lattice, 7, 5));
}

TEST(UniformPoints, FillTheDomain) {
    const Lattice lattice({0.3, 1.1}, {1, 0.2});
    const Points p = uniform_points(lattice, 20000, 1);
    Vec2 mean(0, 0);
    for (Eigen::Index k = 0; k < p.cols(); ++k) {
        const Vec2 u = lattice.to_lattice(p.col(k));
        EXPECT_GT(u.minCoeff(), -1e-15);
        EXPECT_LT(u.maxCoeff(), 1 + 1e-15);
        mean += u / double(p.cols());
    }
    EXPECT_LT((mean - Vec2(0.5, 0.5)).norm(), 5 * std::sqrt(1 / 6.0 / 20000));
}

TEST(UniformPoints, RejectANumberBelowOne) {
    EXPECT_THROW(uniform_points(Lattice::rectangle(1, 1), 0, 0), InvalidInput);
}

}  // namespace
}  // namespace pcvt::plane
