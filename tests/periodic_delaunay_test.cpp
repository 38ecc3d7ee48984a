#include "mesher/periodic_delaunay.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "mesher/energy.hpp"
#include "tests/support/lattices.hpp"
#include "tests/support/nearest_site.hpp"
#include "tests/support/special_sites.hpp"

namespace pcvt {
namespace {

using testing::lattices;
using testing::squared_distance;

Sites random_sites(const Lattice& lattice, int n, std::uint64_t seed) {
    return {lattice, uniform_points(lattice, n, seed)};
}

using Edges = std::vector<std::tuple<SiteId, SiteId, Offset>>;

Edges edges(const TorusTriangulation& t) {
    Edges edges;
    for (int h = 0; h < t.n_halfedges(); ++h) {
        edges.emplace_back(t.corner(h).site, t.corner(TorusTriangulation::next(h)).site,
                           t.edge_offset(h));
    }
    std::sort(edges.begin(), edges.end());
    return edges;
}

// Law 1, checked in another way: no image of any site lies inside any circumcircle.
void expect_empty_circles(const PeriodicDelaunay& delaunay) {
    const Sites& sites = delaunay.sites();
    const Lattice& reduced = sites.reduction().reduced;
    const TorusTriangulation& t = delaunay.triangulation();
    for (int h = 0; h < t.n_halfedges(); h += 3) {
        std::array<Vec2, 3> p;
        for (int k = 0; k < 3; ++k) {
            const Corner& c = t.corner(h + k);
            p[k] = sites.position(c.site) + reduced.translation(c.offset);
        }
        const Vec2 d = p[1] - p[0];
        const Vec2 e = p[2] - p[0];
        const double det = 2 * (d.x() * e.y() - d.y() * e.x());
        ASSERT_GT(det, 0);
        const Vec2 along = (d.squaredNorm() * e - e.squaredNorm() * d) / det;
        const Vec2 radius(along.y(), -along.x());
        const double nearest = squared_distance(sites, p[0] + radius);
        ASSERT_GT(nearest, radius.squaredNorm() * (1 - 1e-8));
    }
}

TEST(PeriodicDelaunay, CirclesAreEmptyForSmallNOnEveryLattice) {
    for (const auto& [name, lattice] : lattices()) {
        for (const int n : {1, 2, 3, 4, 5, 6, 7, 8, 30}) {
            SCOPED_TRACE(name + " n = " + std::to_string(n));
            expect_empty_circles(PeriodicDelaunay(random_sites(lattice, n, 1)));
        }
    }
}

TEST(PeriodicDelaunay, CirclesAreEmptyWhereSitesAreCocircular) {
    for (const auto& [name, sites] : testing::special_sites()) {
        SCOPED_TRACE(name);
        expect_empty_circles(PeriodicDelaunay(sites));
    }
}

// Law 2: after moves from 1e-12 to several domains, the edges are those of a fresh build.
TEST(PeriodicDelaunay, AMoveOfAnySizeEqualsAFreshBuild) {
    std::mt19937_64 random(3);
    std::normal_distribution<double> normal;
    const auto named = lattices();
    for (int k = 0; k < 400; ++k) {
        const auto& [name, lattice] = named[static_cast<std::size_t>(k) % named.size()];
        const int n = 1 + k % 25;
        Points points = uniform_points(lattice, n, random());
        PeriodicDelaunay moved(Sites(lattice, points));
        for (int move = 0; move < 6; ++move) {
            const double size = moved.sites().spacing() * std::pow(10.0, (k + move) % 14 - 12);
            for (double& x : points.reshaped()) x += size * normal(random);
            ASSERT_TRUE(moved.move_to(points));
            moved.certify();
            const PeriodicDelaunay fresh(Sites(lattice, points));
            ASSERT_EQ(edges(moved.triangulation()), edges(fresh.triangulation())) << name << k;
        }
    }
}

TEST(PeriodicDelaunay, SmallMovesAreRepairedWithoutARebuild) {
    const Lattice unit = Lattice::rectangle(1, 1);
    Points points = uniform_points(unit, 2000, 1);
    PeriodicDelaunay delaunay(Sites(unit, points));
    std::mt19937_64 random(1);
    std::normal_distribution<double> normal;
    for (int move = 0; move < 20; ++move) {
        for (double& x : points.reshaped()) x += 1e-7 * normal(random);
        ASSERT_TRUE(delaunay.move_to(points));
    }
    EXPECT_EQ(delaunay.n_rebuilds(), 0);
}

TEST(PeriodicDelaunay, CoincidentSitesAreRejectedAndForgotten) {
    const Lattice lattice({1, 0}, {7, 1});
    Points points = uniform_points(lattice, 6, 1);
    PeriodicDelaunay delaunay(Sites(lattice, points));
    Points bad = points;
    bad.col(4) = bad.col(1) + lattice.translation({-2, 1});
    EXPECT_FALSE(delaunay.move_to(bad));
    bad.setConstant(0.25);
    EXPECT_FALSE(delaunay.move_to(bad));
    ASSERT_TRUE(delaunay.move_to(points));
    delaunay.certify();
    EXPECT_EQ(edges(delaunay.triangulation()),
              edges(PeriodicDelaunay(Sites(lattice, points)).triangulation()));
}

}  // namespace
}  // namespace pcvt
