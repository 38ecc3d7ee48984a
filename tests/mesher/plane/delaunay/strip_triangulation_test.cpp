#include "mesher/plane/delaunay/strip_triangulation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>

#include "mesher/plane/delaunay/moving_delaunay.hpp"
#include "mesher/plane/delaunay/periodic_delaunay.hpp"
#include "tests/support/lattices.hpp"
#include "tests/support/site_columns.hpp"
#include "tests/support/special_sites.hpp"
#include "tests/support/triangulation_laws.hpp"

namespace pcvt::plane {
namespace {

using Wide = boost::multiprecision::int128_t;
using testing::columns_of;
using testing::lattices;
using testing::random_lattice;

std::optional<TorusTriangulation> strips_of(const Sites& sites) {
    return strip_triangulation(sites.coordinates(), columns_of(sites));
}

/// Twice the area of a triangle, in units of 2^-102 of the domain; positive if counter-clockwise.
Wide exact_doubled_area(const Image& p, const Image& q, const Image& r) {
    const Vec2 d = difference(p, q) * 0x1p51;
    const Vec2 e = difference(p, r) * 0x1p51;
    return Wide(d.x()) * Wide(e.y()) - Wide(d.y()) * Wide(e.x());
}

// Expects triangles that are counter-clockwise and cover the torus once.
void expect_triangulation(const TorusTriangulation& t, const Sites& sites) {
    ASSERT_EQ(t.n_sites(), sites.n_sites());
    testing::expect_laws(t);
    Wide sum = 0;
    for (int h = 0; h < t.n_halfedges(); h += 3) {
        std::array<Image, 3> corner;
        for (int k = 0; k < 3; ++k) {
            const Corner c = t.corner(h + k);
            corner[k] = image(sites, c.site, c.offset);
        }
        const Wide doubled = exact_doubled_area(corner[0], corner[1], corner[2]);
        ASSERT_GT(doubled, 0);
        sum += doubled;
    }
    ASSERT_EQ(sum, Wide(1) << 103);
}

void expect_strips(const Sites& sites) {
    const auto strips = strips_of(sites);
    ASSERT_TRUE(strips.has_value());
    expect_triangulation(*strips, sites);
}

TEST(StripTriangulation, CoversTheTorusForAnyNumberOfSitesOnEveryLattice) {
    for (const auto& [name, lattice] : lattices()) {
        for (const int n : {1, 2, 3, 4, 5, 6, 7, 8, 9, 30, 500}) {
            SCOPED_TRACE(name + " n = " + std::to_string(n));
            expect_strips(Sites(lattice, uniform_points(lattice, n, 1)));
        }
    }
}

TEST(StripTriangulation, CoversTheTorusForRandomLattices) {
    std::mt19937_64 random(2);
    for (int k = 0; k < 1500; ++k) {
        const Lattice lattice = random_lattice(random);
        SCOPED_TRACE("input " + std::to_string(k));
        expect_strips(Sites(lattice, uniform_points(lattice, 1 + k % 40, random())));
        if (HasFatalFailure()) return;
    }
}

// Chains that lean to either side and overlap each other by far.
TEST(StripTriangulation, CoversTheTorusWhereSitesAreClustered) {
    std::mt19937_64 random(3);
    std::normal_distribution<double> normal;
    for (int k = 0; k < 400; ++k) {
        const Lattice lattice = random_lattice(random);
        Points points = uniform_points(lattice, 5 + k % 60, random());
        const Vec2 spread(std::pow(10, -(k % 4)), std::pow(10, -(k % 5)));
        for (Eigen::Index s = 0; s < points.cols() - 1; ++s) {
            const Vec2 u(spread.x() * normal(random), spread.y() * normal(random));
            points.col(s) = lattice.to_position(u);
        }
        SCOPED_TRACE("input " + std::to_string(k));
        expect_strips(Sites(lattice, points));
        if (HasFatalFailure()) return;
    }
}

// A chain that is straight up to a few units in the last place and leans far away from the sites of
// its neighbour: three consecutive sites form a triangle or not.
TEST(StripTriangulation, IsExactWhereAChainIsNearlyStraight) {
    std::mt19937_64 random(8);
    std::uniform_real_distribution<double> uniform(0, 1);
    const Lattice unit = Lattice::rectangle(1, 1);
    for (int k = 0; k < 3000; ++k) {
        const double lean = (k % 2 == 0 ? 0.45 : -0.45) * uniform(random);
        const double rise = 0.4 * uniform(random);
        Points u(2, 8);
        for (int s = 0; s < 4; ++s) {
            const double t = uniform(random);
            u.col(s) << wrap(0.225 + lean * (t - 0.5)).fraction, wrap(rise * t).fraction;
            u.col(s + 4) << wrap(0.5 + 0.4 * uniform(random)).fraction,
                wrap(0.8 + 0.1 * uniform(random)).fraction;
        }
        SCOPED_TRACE("input " + std::to_string(k));
        expect_strips(Sites(unit, reduce(unit), u));
        if (HasFatalFailure()) return;
    }
}

/// Sites that share the coordinate `u` across the boundary between two columns.
Sites touching_sites() {
    const Lattice unit = Lattice::rectangle(1, 1);
    Points points = uniform_points(unit, 100, 7);
    points.row(0).leftCols(30).setConstant(0.5);
    return {unit, points};
}

TEST(StripTriangulation, ReturnsNothingWhereChainsTouch) {
    EXPECT_FALSE(strips_of(touching_sites()).has_value());
    const Lattice unit = Lattice::rectangle(1, 1);
    EXPECT_FALSE(strips_of(testing::grid_sites(unit, 5, 11, 0, 0)).has_value());
}

// Expects that mirrors build the triangulation where strips fail.
void expect_built(const Sites& sites) {
    MovingDelaunay moving(sites);
    EXPECT_EQ(moving.counts().n_mirrors.has_value(), !strips_of(sites).has_value());
    EXPECT_EQ(moving.counts().n_rebuilds, 0);
    auto [released, triangulation] = moving.release();
    EXPECT_EQ(released.coordinates(), sites.coordinates());
    expect_triangulation(triangulation, released);
    EXPECT_NO_THROW(PeriodicDelaunay(released, triangulation));
}

TEST(StripTriangulation, CoversTheTorusOrFallsBackToMirrors) {
    int n_with_strips = 0;
    int n_without = 0;
    for (const auto& [name, sites] : testing::special_sites()) {
        SCOPED_TRACE(name);
        if (strips_of(sites)) {
            ++n_with_strips;
            expect_strips(sites);
        } else {
            ++n_without;
        }
        expect_built(sites);
    }
    expect_built(touching_sites());
    EXPECT_GT(n_with_strips, 10);
    EXPECT_GT(n_without, 5);
}

}  // namespace
}  // namespace pcvt::plane
