#include "mesher/plane/delaunay/site_insertion.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "mesher/plane/delaunay/mirror_diagram.hpp"
#include "mesher/plane/delaunay/periodic_delaunay.hpp"
#include "tests/support/lattices.hpp"
#include "tests/support/special_sites.hpp"

namespace pcvt::plane {
namespace {

Points points_on_a_circle(int n) {
    const Points u = uniform_points(Lattice::rectangle(1, 1), n, 1);
    Points points(2, n);
    for (int s = 0; s < n; ++s) {
        const double angle = 2 * std::numbers::pi * u(0, s);
        points.col(s) = Vec2(0.5 + 0.3 * std::cos(angle), 0.5 + 0.3 * std::sin(angle));
    }
    return points;
}

TEST(PlaneInsertion, EqualsTheMirrorsOnAllLattices) {
    for (const auto& [name, lattice] : testing::lattices()) {
        for (const int n : {1, 2, 3, 7, 40, 300}) {
            SCOPED_TRACE(name + " with " + std::to_string(n));
            const Sites sites(lattice, uniform_points(lattice, n, 5));
            const std::vector<Triangle> mirrors = mirror_diagram(sites).triangles;
            EXPECT_EQ(inserted_triangles(sites), mirrors);
            EXPECT_EQ(inserted_triangles(sites, 1), mirrors);
        }
    }
}

TEST(PlaneInsertion, EqualsTheMirrorsOnTies) {
    for (const auto& [name, sites] : testing::special_sites()) {
        SCOPED_TRACE(name);
        const std::vector<Triangle> mirrors = mirror_diagram(sites).triangles;
        EXPECT_EQ(inserted_triangles(sites), mirrors);
        EXPECT_EQ(inserted_triangles(sites, 1), mirrors);
    }
    const Lattice unit = Lattice::rectangle(1, 1);
    for (const Points& points : {points_on_a_circle(300), Points(1e-6 * points_on_a_circle(300))}) {
        const Sites sites(unit, points);
        EXPECT_EQ(inserted_triangles(sites), mirror_diagram(sites).triangles);
    }
}

// A hundred thousand of such sites took half a minute by strips and by mirrors.
TEST(PlaneInsertion, SlowUnevenSitesTakeNoQuadraticTime) {
    const Lattice unit = Lattice::rectangle(1, 1);
    const int n = 20'000;
    Points line = uniform_points(unit, n, 1);
    line.row(1).setConstant(0.5);
    Points diagonal = line;
    diagonal.row(1) = line.row(0);
    for (const Points& points : {line, diagonal, points_on_a_circle(n)}) {
        const Sites sites(unit, points);
        const PeriodicDelaunay delaunay(sites, {n, inserted_triangles(sites)});
        EXPECT_EQ(delaunay.triangulation().n_triangles(), 2 * n);
    }
}

}  // namespace
}  // namespace pcvt::plane
