#include "mesher/space/delaunay/mirror_diagram.hpp"

#include <gtest/gtest.h>

#include "tests/support/space_families.hpp"
#include "tests/support/space_laws.hpp"

namespace pcvt::space {
namespace {

using testing::space_site_families;

std::vector<Tetrahedron> sorted(const MirrorDiagram& mirrors) {
    std::vector<Tetrahedron> all;
    for (const Tetrahedron& t : mirrors.tetrahedra) all.push_back(testing::canonical(t));
    std::sort(all.begin(), all.end());
    return all;
}

TEST(MirrorDiagram, SlowEqualFullCopies) {
    for (const auto& [name, sites] : space_site_families(1)) {
        if (sites.n_sites() > 9) continue;
        SCOPED_TRACE(name);
        EXPECT_EQ(sorted(mirror_diagram(sites)), sorted(full_copies_diagram(sites)));
    }
}

/// CGAL lists the cells of both in different orders.
TEST(MirrorDiagram, HaveAnOrderOfTheirOwn) {
    for (const auto& [name, sites] : space_site_families(1)) {
        if (sites.n_sites() > 9) continue;
        EXPECT_EQ(mirror_diagram(sites).tetrahedra, full_copies_diagram(sites).tetrahedra) << name;
    }
}

/// The exact checker: no image within two periods lies inside of a circumsphere, nor on it against
/// the rule.
TEST(MirrorDiagram, SlowSpheresAreEmpty) {
    for (const auto& [name, sites] : space_site_families(2)) {
        SCOPED_TRACE(name);
        // Two periods where a tetrahedron may span one, else one.
        const int reach = sites.n_sites() <= 8 ? 2 : 1;
        const int width = 2 * reach + 1;
        const Gram gram = gram_of(sites.reduction().reduced);
        const Points& coordinates = sites.coordinates();
        const auto at = [&coordinates](const Corner& c) { return image(coordinates, c); };
        for (const Tetrahedron& t : mirror_diagram(sites).tetrahedra) {
            ASSERT_GT(orientation(at(t[0]), at(t[1]), at(t[2]), at(t[3])), 0);
            for (SiteId s = 0; s < sites.n_sites(); ++s) {
                for (int o = 0; o < width * width * width; ++o) {
                    const Corner other{s,
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

TEST(MirrorDiagram, SlowFillTheTorusOnce) {
    for (const auto& [name, sites] : space_site_families(3)) {
        SCOPED_TRACE(name);
        const TorusTetrahedra torus(sites.n_sites(), mirror_diagram(sites).tetrahedra);
        testing::expect_torus(torus, sites.coordinates());
    }
}

TEST(MirrorDiagram, AreFewForManySites) {
    const Lattice cube = Lattice::box(1, 1, 1);
    const int n = 8000;
    const Sites sites(cube, uniform_points(cube, n, 1));
    const MirrorDiagram mirrors = mirror_diagram(sites);
    EXPECT_LT(mirrors.n_mirrors, 0.5 * n);
    const TorusTetrahedra torus(n, mirrors.tetrahedra);
    testing::expect_torus(torus, sites.coordinates());
    testing::expect_delaunay(torus, sites.coordinates(), gram_of(sites.reduction().reduced));
}

/// Moving the origin moves images across the seam, but not the triangulation.
TEST(MirrorDiagram, DoNotDependOnTheSeam) {
    const Lattice cube = Lattice::box(1, 1, 1);
    for (const auto& [name, u] : testing::special_coordinates(4)) {
        SCOPED_TRACE(name);
        const Sites sites(cube, u);
        Points moved = u;
        moved.colwise() += Vec3(0.375, 0.5, 0.75);
        const Sites other(cube, moved);
        std::vector<Offset> wraps;
        for (Eigen::Index s = 0; s < u.cols(); ++s) wraps.push_back(wrap(moved.col(s)).whole);
        std::vector<Tetrahedron> expected;
        for (Tetrahedron t : mirror_diagram(sites).tetrahedra) {
            for (Corner& corner : t) corner.offset = corner.offset + wraps[corner.site];
            expected.push_back(testing::canonical(t));
        }
        std::sort(expected.begin(), expected.end());
        EXPECT_EQ(sorted(mirror_diagram(other)), expected);
    }
}

TEST(EuclideanTetrahedra, AreThoseOfTheSitesAlone) {
    const Lattice cube = Lattice::box(1, 1, 1);
    EXPECT_EQ(euclidean_tetrahedra(Sites(cube, uniform_points(cube, 3, 1))), 0u);
    EXPECT_EQ(euclidean_tetrahedra(Sites(cube, uniform_points(cube, 4, 1))), 1u);
    const auto grid = testing::cubic_points(testing::Cubic::kSimple, 2);
    const std::size_t n_in_cube = euclidean_tetrahedra(Sites(cube, grid));
    EXPECT_GE(n_in_cube, 5u);
    EXPECT_LE(n_in_cube, 6u);
}

}  // namespace
}  // namespace pcvt::space
