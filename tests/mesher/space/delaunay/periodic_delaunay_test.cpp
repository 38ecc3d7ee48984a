#include "mesher/space/delaunay/periodic_delaunay.hpp"

#include <gtest/gtest.h>

#include "tests/support/space_families.hpp"
#include "tests/support/space_laws.hpp"

namespace pcvt::space {
namespace {

TEST(PeriodicDelaunay, SlowEveryFacetIsLocallyDelaunay) {
    for (const auto& [name, sites] : testing::space_site_families(6)) {
        SCOPED_TRACE(name);
        const PeriodicDelaunay delaunay = periodic_delaunay(sites);
        testing::expect_delaunay(delaunay.tetrahedra, sites.coordinates(),
                                 gram_of(sites.reduction().reduced));
    }
}

/// A site that moves by a period's fraction leaves facets that are no longer Delaunay, and
/// tetrahedra that are no longer positive.
TEST(PeriodicDelaunay, MovedSitesAreFound) {
    const Lattice cube = Lattice::box(1, 1, 1);
    const PeriodicDelaunay delaunay = periodic_delaunay(Sites(cube, uniform_points(cube, 50, 1)));
    Points moved = delaunay.sites.coordinates();
    moved.col(7) += Vec3(0.25, 0.25, 0);
    const Gram gram = gram_of(delaunay.sites.reduction().reduced);
    int n_wrong = 0;
    int n_inverted = 0;
    for (int f = 0; f < delaunay.tetrahedra.n_facets(); ++f) {
        if (!is_locally_delaunay(delaunay.tetrahedra, moved, gram, f)) ++n_wrong;
    }
    for (int t = 0; t < delaunay.tetrahedra.n_tetrahedra(); ++t) {
        if (!is_positive(delaunay.tetrahedra, moved, t)) ++n_inverted;
    }
    EXPECT_GT(n_wrong, 0);
    EXPECT_GT(n_inverted, 0);
}

}  // namespace
}  // namespace pcvt::space
