#include "mesher/space/space_mirrors.hpp"

#include <gtest/gtest.h>

#include "tests/support/space_families.hpp"
#include "tests/support/space_laws.hpp"

namespace pcvt {
namespace {

using testing::space_site_families;

std::vector<Tetrahedron> sorted(const SpaceMirrors& mirrors) {
    std::vector<Tetrahedron> all;
    for (const Tetrahedron& t : mirrors.tetrahedra) all.push_back(testing::canonical(t));
    std::sort(all.begin(), all.end());
    return all;
}

TEST(SpaceMirrors, SlowEqualFullCopies) {
    for (const auto& [name, sites] : space_site_families(1)) {
        if (sites.n_sites() > 9) continue;
        SCOPED_TRACE(name);
        EXPECT_EQ(sorted(space_mirrors(sites)), sorted(space_full_copies(sites)));
    }
}

/// CGAL lists the cells of both in different orders.
TEST(SpaceMirrors, HaveAnOrderOfTheirOwn) {
    for (const auto& [name, sites] : space_site_families(1)) {
        if (sites.n_sites() > 9) continue;
        EXPECT_EQ(space_mirrors(sites).tetrahedra, space_full_copies(sites).tetrahedra) << name;
    }
}

/// The exact checker: no image within two periods lies inside of a circumsphere, nor on it against
/// the rule.
TEST(SpaceMirrors, SlowSpheresAreEmpty) {
    for (const auto& [name, sites] : space_site_families(2)) {
        SCOPED_TRACE(name);
        // Two periods where a tetrahedron may span one, else one.
        const int reach = sites.n_sites() <= 8 ? 2 : 1;
        const int width = 2 * reach + 1;
        const Gram3 gram = gram_of(sites.reduction().reduced);
        const Points3& coordinates = sites.coordinates();
        const auto at = [&coordinates](const Corner3& c) { return image(coordinates, c); };
        for (const Tetrahedron& t : space_mirrors(sites).tetrahedra) {
            ASSERT_GT(orientation(at(t[0]), at(t[1]), at(t[2]), at(t[3])), 0);
            for (SiteId s = 0; s < sites.n_sites(); ++s) {
                for (int o = 0; o < width * width * width; ++o) {
                    const Corner3 other{s,
                                        {o / (width * width) - reach, o / width % width - reach,
                                         o % width - reach}};
                    if (std::find(t.begin(), t.end(), other) != t.end()) continue;
                    ASSERT_FALSE(
                        violates_delaunay(gram, at(t[0]), at(t[1]), at(t[2]), at(t[3]), at(other)));
                }
            }
        }
    }
}

TEST(SpaceMirrors, SlowFillTheTorusOnce) {
    for (const auto& [name, sites] : space_site_families(3)) {
        SCOPED_TRACE(name);
        const TorusTetrahedra torus(sites.n_sites(), space_mirrors(sites).tetrahedra);
        testing::expect_torus(torus, sites.coordinates());
    }
}

TEST(SpaceMirrors, AreFewForManySites) {
    const SpaceLattice cube = SpaceLattice::box(1, 1, 1);
    const int n = 8000;
    const SpaceSites sites(cube, uniform_points(cube, n, 1));
    const SpaceMirrors mirrors = space_mirrors(sites);
    EXPECT_LT(mirrors.n_mirrors, 0.5 * n);
    const TorusTetrahedra torus(n, mirrors.tetrahedra);
    testing::expect_torus(torus, sites.coordinates());
    testing::expect_delaunay(torus, sites.coordinates(), gram_of(sites.reduction().reduced));
}

/// Moving the origin moves images across the seam, but not the triangulation.
TEST(SpaceMirrors, DoNotDependOnTheSeam) {
    const SpaceLattice cube = SpaceLattice::box(1, 1, 1);
    for (const auto& [name, u] : testing::special_coordinates(4)) {
        SCOPED_TRACE(name);
        const SpaceSites sites(cube, u);
        Points3 moved = u;
        moved.colwise() += Vec3(0.375, 0.5, 0.75);
        const SpaceSites other(cube, moved);
        std::vector<Offset3> wraps;
        for (Eigen::Index s = 0; s < u.cols(); ++s) wraps.push_back(wrap(moved.col(s)).whole);
        std::vector<Tetrahedron> expected;
        for (Tetrahedron t : space_mirrors(sites).tetrahedra) {
            for (Corner3& corner : t) corner.offset = corner.offset + wraps[corner.site];
            expected.push_back(testing::canonical(t));
        }
        std::sort(expected.begin(), expected.end());
        EXPECT_EQ(sorted(space_mirrors(other)), expected);
    }
}

TEST(EuclideanTetrahedra, AreThoseOfTheSitesAlone) {
    const SpaceLattice cube = SpaceLattice::box(1, 1, 1);
    EXPECT_EQ(euclidean_tetrahedra(SpaceSites(cube, uniform_points(cube, 3, 1))), 0u);
    EXPECT_EQ(euclidean_tetrahedra(SpaceSites(cube, uniform_points(cube, 4, 1))), 1u);
    const auto grid = testing::cubic_points(testing::Cubic::kSimple, 2);
    const std::size_t n_in_cube = euclidean_tetrahedra(SpaceSites(cube, grid));
    EXPECT_GE(n_in_cube, 5u);
    EXPECT_LE(n_in_cube, 6u);
}

}  // namespace
}  // namespace pcvt
