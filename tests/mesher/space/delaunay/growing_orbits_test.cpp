#include "mesher/space/delaunay/growing_orbits.hpp"

#include <gtest/gtest.h>

#include "mesher/space/delaunay/mirror_diagram.hpp"
#include "tests/support/random_space_sites.hpp"
#include "tests/support/space_families.hpp"
#include "tests/support/space_laws.hpp"

namespace pcvt::space {
namespace {

/// Whether the spheres of one site are small enough: those of the longest diagonal of the periods.
bool has_small_periods(const Lattice& reduced) {
    const double diagonal = std::sqrt(reduced.a().squaredNorm() + reduced.b().squaredNorm() +
                                      reduced.c().squaredNorm());
    return diagonal < GrowingOrbits::kLargestExtent * reduced.heights().minCoeff();
}

Points first_columns(const Points& points, int n) { return points.leftCols(n); }

/// Expects that insertion after the first sites gives the tetrahedra of the mirrors.
void expect_growth(const Sites& sites, int n_first) {
    const Gram gram = gram_of(sites.reduction().reduced);
    const Sites few(sites.lattice(), sites.reduction(),
                    first_columns(sites.coordinates(), n_first));
    GrowingOrbits growing(gram, sites.coordinates(),
                          TorusTetrahedra(n_first, mirror_diagram(few).tetrahedra));
    for (SiteId s = n_first; s < sites.n_sites(); ++s) ASSERT_TRUE(growing.insert(s));
    std::vector<Tetrahedron> tetrahedra = growing.tetrahedra();
    put_in_canonical_order(sites.n_sites(), tetrahedra);
    EXPECT_EQ(tetrahedra, mirror_diagram(sites).tetrahedra);
    const TorusTetrahedra torus(sites.n_sites(), tetrahedra);
    testing::expect_torus(torus, sites.coordinates());
    testing::expect_delaunay(torus, sites.coordinates(), gram);
}

// From one site on, the cavities of many images overlap.
TEST(GrowingOrbits, EqualTheMirrorsFromOneSiteOn) {
    int n_grown = 0;
    for (const auto& [name, sites] : testing::space_site_families(3)) {
        if (!has_small_periods(sites.reduction().reduced)) continue;
        SCOPED_TRACE(name);
        expect_growth(sites, 1);
        ++n_grown;
    }
    EXPECT_GT(n_grown, 60);
}

TEST(GrowingOrbits, SlowEqualTheMirrorsOfRandomJobs) {
    std::mt19937_64 random(11);
    for (int k = 0; k < 150; ++k) {
        const auto [name, sites] = testing::random_space_sites(random);
        if (sites.n_sites() > 120 || !has_small_periods(sites.reduction().reduced)) continue;
        SCOPED_TRACE(name);
        expect_growth(sites, 1);
    }
}

TEST(GrowingOrbits, RefuseASiteTwice) {
    const Sites sites(testing::kCube, uniform_points(testing::kCube, 4, 1));
    Points twice(3, 6);
    twice << sites.coordinates(), sites.coordinates().leftCols(2);
    GrowingOrbits growing(gram_of(sites.reduction().reduced), twice,
                          TorusTetrahedra(4, mirror_diagram(sites).tetrahedra));
    const int before = growing.n_tetrahedra();
    EXPECT_FALSE(growing.insert(4));
    EXPECT_FALSE(growing.insert(5));
    EXPECT_EQ(growing.n_tetrahedra(), before);
}

}  // namespace
}  // namespace pcvt::space
