#include "mesher/space/delaunay/orbit_insertion.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "mesher/space/delaunay/mirror_diagram.hpp"
#include "tests/support/space_families.hpp"
#include "tests/support/space_laws.hpp"

namespace pcvt::space {
namespace {

using testing::kCube;

/// Sites in the unit cube on a line, in a plane, on a circle, on a sphere, in a cluster and on two
/// lines.
std::vector<std::pair<std::string, Points>> uneven_points(int n) {
    const Points u = uniform_points(kCube, n, 1);
    Points line = u;
    line.bottomRows(2).setConstant(0.5);
    Points diagonal = u;
    diagonal.row(1) = diagonal.row(2) = u.row(0);
    Points plane = u;
    plane.row(2).setConstant(0.25);
    Points circle(3, n);
    Points sphere(3, n);
    for (int s = 0; s < n; ++s) {
        const double angle = 2 * std::numbers::pi * u(0, s);
        const double z = 2 * u(1, s) - 1;
        const Vec3 d(std::cos(angle), std::sin(angle), 0);
        circle.col(s) = Vec3::Constant(0.5) + 0.3 * d;
        sphere.col(s) = Vec3::Constant(0.5) + 0.3 * (std::sqrt(1 - z * z) * d + Vec3(0, 0, z));
    }
    Points lines = line;
    for (int s = 0; s < n; s += 2) lines.col(s) = Vec3(0.25, u(0, s), 0.75);
    // Across the seam.
    const Points cluster = (u.array() - 0.5) * 1e-6;
    return {{"line", line},     {"diagonal", diagonal}, {"plane", plane}, {"circle", circle},
            {"sphere", sphere}, {"cluster", cluster},   {"lines", lines}};
}

TEST(OrbitInsertion, SlowEqualsTheMirrorsOnUnevenSites) {
    for (const auto& [name, points] : uneven_points(150)) {
        SCOPED_TRACE(name);
        const Sites sites(kCube, points);
        const auto torus = orbit_tetrahedra(sites);
        ASSERT_TRUE(torus);
        testing::expect_torus(*torus, sites.coordinates());
        testing::expect_delaunay(*torus, sites.coordinates(), gram_of(sites.reduction().reduced));
        EXPECT_EQ(testing::canonical_tetrahedra(*torus),
                  testing::canonical_tetrahedra({150, mirror_diagram(sites).tetrahedra}));
    }
}

TEST(OrbitInsertion, EqualsTheMirrorsOnAllLattices) {
    for (const auto& [name, lattice] : testing::space_lattices()) {
        SCOPED_TRACE(name);
        const Sites sites(lattice, uniform_points(lattice, 100, 2));
        const auto torus = orbit_tetrahedra(sites);
        if (!torus) continue;
        EXPECT_EQ(testing::canonical_tetrahedra(*torus),
                  testing::canonical_tetrahedra({100, mirror_diagram(sites).tetrahedra}));
    }
}

TEST(OrbitInsertion, RefusesFewSitesAndSpheresOfManyPeriods) {
    EXPECT_FALSE(orbit_tetrahedra(Sites(kCube, uniform_points(kCube, 10, 1))));
    const Lattice column = Lattice::box(1, 1, 100);
    Points plane = uniform_points(column, 100, 1);
    plane.row(2).setConstant(3);
    EXPECT_FALSE(orbit_tetrahedra(Sites(column, plane)));
}

// Ten thousand sites on a line took more than an hour by mirrors.
TEST(OrbitInsertion, SlowUnevenSitesTakeNoQuadraticTime) {
    for (const auto& [name, points] : uneven_points(10'000)) {
        if (name == "lines") continue;
        SCOPED_TRACE(name);
        const Sites sites(kCube, points);
        const auto torus = orbit_tetrahedra(sites);
        ASSERT_TRUE(torus);
        EXPECT_LT(torus->n_tetrahedra(), 80'000);
    }
}

TEST(OrbitInsertion, ExpectsTheNumberOfTetrahedra) {
    for (const auto& [name, points] : uneven_points(1000)) {
        SCOPED_TRACE(name);
        const Sites sites(kCube, points);
        const double n = orbit_tetrahedra(sites)->n_tetrahedra();
        EXPECT_NEAR(expected_tetrahedra(sites) / n, 1, 0.3);
    }
    const Sites sites(kCube, uniform_points(kCube, 1000, 5));
    EXPECT_NEAR(expected_tetrahedra(sites) / 6770, 1, 0.2);
}

}  // namespace
}  // namespace pcvt::space
