#include "mesher/space/delaunay/site_insertion.hpp"

#include <gtest/gtest.h>

#include "mesher/base/error.hpp"
#include "mesher/space/delaunay/mirror_diagram.hpp"
#include "tests/support/space_families.hpp"
#include "tests/support/space_laws.hpp"

namespace pcvt::space {
namespace {

using testing::canonical_tetrahedra;
using testing::Cubic;
using testing::cubic_points;
using testing::in_lattice;

/// Expects that the sites are inserted, and that the result is that of the mirrors.
void expect_that_of_mirrors(const Sites& sites) {
    const auto inserted = inserted_tetrahedra(sites);
    ASSERT_TRUE(inserted);
    testing::expect_torus(*inserted, sites.coordinates());
    const TorusTetrahedra mirrors(sites.n_sites(), mirror_diagram(sites).tetrahedra);
    EXPECT_EQ(canonical_tetrahedra(*inserted), canonical_tetrahedra(mirrors));
}

TEST(SiteInsertion, SlowEqualsTheMirrorsOnAllLattices) {
    for (const auto& [name, lattice] : testing::space_lattices()) {
        SCOPED_TRACE(name);
        // Slender lattices need more sites: a box of the sample has about equal edges.
        const bool slender = name == "column" || name == "plate" || name == "needle";
        if (slender && name != "column") continue;
        const int n = slender ? 14'000 : 3000;
        expect_that_of_mirrors(Sites(lattice, uniform_points(lattice, n, 3)));
    }
}

/// Exact cubic lattices of points, all of whose spheres are ties.
TEST(SiteInsertion, SlowEqualsTheMirrorsOnCubicPoints) {
    for (const auto& [name, lattice] : testing::space_lattices()) {
        if (name != "cube" && name != "oblique" && name != "hexagonal") continue;
        for (const auto& [kind, m] :
             {std::pair(Cubic::kSimple, 13), {Cubic::kBodyCentred, 10}, {Cubic::kFaceCentred, 8}}) {
            SCOPED_TRACE(name + " " + std::to_string(int(kind)));
            expect_that_of_mirrors(Sites(lattice, in_lattice(lattice, cubic_points(kind, m))));
        }
    }
}

/// Points moved by the last digits of their coordinates, so that spheres are nearly ties, in one
/// box of the sample.
TEST(SiteInsertion, EqualsTheMirrorsOnNearlyCubicPoints) {
    const Lattice cube = Lattice::box(1, 1, 1);
    std::mt19937_64 random(5);
    for (const double size : {0x1p-49, 0x1p-42, 0x1p-30}) {
        SCOPED_TRACE(size);
        Points u(3, 2000 + 432);
        u.leftCols(2000) = uniform_points(cube, 2000, 8);
        u.rightCols(432) = cubic_points(Cubic::kBodyCentred, 6) / 8;
        for (double& x : u.rightCols(432).reshaped()) x += size * double(random() % 3);
        expect_that_of_mirrors(Sites(cube, u));
    }
}

/// Sites on a sphere round a site and in rows and planes, among sites that are spread evenly.
TEST(SiteInsertion, EqualsTheMirrorsOnSpecialSitesAmongOthers) {
    const Lattice cube = Lattice::box(1, 1, 1);
    for (const auto& [name, u] : testing::special_coordinates(2)) {
        SCOPED_TRACE(name);
        Points all(3, 2000 + u.cols());
        all.leftCols(2000) = uniform_points(cube, 2000, 8);
        all.rightCols(u.cols()) = u;
        expect_that_of_mirrors(Sites(cube, all));
    }
}

TEST(SiteInsertion, EqualsTheFullCopies) {
    const Lattice cube = Lattice::box(1, 1, 1);
    const Sites sites(cube, uniform_points(cube, 1500, 4));
    const auto inserted = inserted_tetrahedra(sites);
    ASSERT_TRUE(inserted);
    const TorusTetrahedra copies(1500, full_copies_diagram(sites).tetrahedra);
    EXPECT_EQ(canonical_tetrahedra(*inserted), canonical_tetrahedra(copies));
}

TEST(SiteInsertion, SortsTetrahedraByTheirSmallestSite) {
    const Lattice cube = Lattice::box(1, 1, 1);
    const auto torus = inserted_tetrahedra(Sites(cube, uniform_points(cube, 3000, 1)));
    ASSERT_TRUE(torus);
    SiteId before = 0;
    for (int t = 0; t < torus->n_tetrahedra(); ++t) {
        const auto sites = torus->corner_sites().subspan(4 * std::size_t(t), 4);
        const SiteId smallest = *std::min_element(sites.begin(), sites.end());
        EXPECT_LE(before, smallest);
        before = smallest;
    }
}

TEST(SiteInsertion, RefusesFewSitesAndClusters) {
    const Lattice cube = Lattice::box(1, 1, 1);
    for (const int n : {1, 2, 8, 100}) {
        EXPECT_FALSE(inserted_tetrahedra(Sites(cube, uniform_points(cube, n, 1)))) << n;
    }
    const Points points = uniform_points(cube, 3000, 1);
    EXPECT_FALSE(inserted_tetrahedra(Sites(cube, points / 2)));
    // Most boxes have sites, but a large hole has none.
    Points pierced = points;
    for (Eigen::Index s = 0; s < pierced.cols(); ++s) {
        if ((pierced.col(s).array() < 0.45).all()) pierced(0, s) = 0.5 + 0.001 * pierced(0, s);
    }
    EXPECT_FALSE(inserted_tetrahedra(Sites(cube, pierced)));
}

}  // namespace
}  // namespace pcvt::space
