#include "mesher/space/delaunay/torus_tetrahedra.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

#include "mesher/base/error.hpp"
#include "tests/support/space_families.hpp"
#include "tests/support/space_laws.hpp"

namespace pcvt::space {
namespace {

using testing::canonical_tetrahedra;

TEST(TorusTetrahedra, SlowLinkFacetsOfAllFamilies) {  // laws 1 to 3
    for (const auto& [name, sites] : testing::space_site_families(5)) {
        SCOPED_TRACE(name);
        const PeriodicDelaunay delaunay = periodic_delaunay(sites);
        testing::expect_torus(delaunay.tetrahedra, sites.coordinates());
    }
}

TEST(TorusTetrahedra, OneSiteHasSixTetrahedra) {
    for (const auto& [name, lattice] : testing::space_lattices()) {
        SCOPED_TRACE(name);
        const Sites sites(lattice, Points::Constant(3, 1, 0.3));
        EXPECT_EQ(periodic_delaunay(sites).tetrahedra.n_tetrahedra(), 6);
    }
}

TEST(TorusTetrahedra, FacetsTurnTowardsTheirCorner) {
    const Lattice cube = Lattice::box(1, 1, 1);
    const PeriodicDelaunay delaunay = periodic_delaunay(Sites(cube, uniform_points(cube, 9, 1)));
    const Points& u = delaunay.sites.coordinates();
    const TorusTetrahedra& t = delaunay.tetrahedra;
    for (int f = 0; f < t.n_facets(); ++f) {
        const auto [a, b, c] = t.facet(f);
        EXPECT_EQ(orientation(image(u, a), image(u, b), image(u, c), image(u, t.corner(f))), 1);
        EXPECT_EQ(orientation(image(u, a), image(u, b), image(u, c), image(u, t.apex_across(f))),
                  -1);
    }
}

TEST(TorusTetrahedra, RejectsAHole) {
    const Lattice cube = Lattice::box(1, 1, 1);
    const PeriodicDelaunay delaunay = periodic_delaunay(Sites(cube, uniform_points(cube, 9, 1)));
    std::vector<Tetrahedron> all = canonical_tetrahedra(delaunay.tetrahedra);
    EXPECT_TRUE(match_facets(9, all));
    all.pop_back();
    EXPECT_FALSE(match_facets(9, all));
    EXPECT_THROW(TorusTetrahedra(9, all), InternalError);
    all.push_back(all.front());
    all.push_back(all.front());
    EXPECT_FALSE(match_facets(9, all));
}

TEST(TorusTetrahedra, OffsetsFollowWrappedSites) {
    const Lattice cube = Lattice::box(1, 1, 1);
    for (const int n : {1, 2, 20}) {
        PeriodicDelaunay delaunay = periodic_delaunay(Sites(cube, uniform_points(cube, n, 1)));
        Points moved = delaunay.sites.coordinates();
        std::vector<Offset> change(static_cast<std::size_t>(n));
        for (SiteId s = 0; s < n; ++s) {
            change[s] = {s % 3 - 1, s % 2, -(s % 5)};
            moved.col(s) -= change[s].vector();
        }
        delaunay.tetrahedra.add_to_offsets(change);
        testing::expect_torus(delaunay.tetrahedra, moved);
    }
}

TEST(TorusTetrahedra, RenumberingKeepsTheComplex) {
    const Lattice cube = Lattice::box(1, 1, 1);
    const int n = 20;
    PeriodicDelaunay delaunay = periodic_delaunay(Sites(cube, uniform_points(cube, n, 1)));
    std::vector<SiteId> number(n);
    std::iota(number.rbegin(), number.rend(), 0);
    delaunay.tetrahedra.renumber_sites(number);
    testing::expect_torus(delaunay.tetrahedra, delaunay.sites.coordinates().rowwise().reverse());
}

TEST(TorusTetrahedra, SortingOrdersThemByTheirSmallestSite) {
    const Lattice cube = Lattice::box(1, 1, 1);
    for (const int n : {1, 2, 5, 200}) {
        SCOPED_TRACE(n);
        PeriodicDelaunay delaunay = periodic_delaunay(Sites(cube, uniform_points(cube, n, 2)));
        std::vector<SiteId> number(static_cast<std::size_t>(n));
        std::iota(number.begin(), number.end(), 0);
        std::shuffle(number.begin(), number.end(), std::mt19937_64(3));
        TorusTetrahedra& tetrahedra = delaunay.tetrahedra;
        tetrahedra.renumber_sites(number);
        const auto smallest_sites = [&] {
            std::vector<SiteId> sites;
            for (int t = 0; t < tetrahedra.n_tetrahedra(); ++t) {
                const Tetrahedron corners = tetrahedra.tetrahedron(t);
                sites.push_back(std::min_element(corners.begin(), corners.end())->site);
            }
            return sites;
        };
        const std::vector<Tetrahedron> before = canonical_tetrahedra(tetrahedra);
        EXPECT_EQ(std::ranges::is_sorted(smallest_sites()), n < 5);
        tetrahedra.sort();
        EXPECT_TRUE(std::ranges::is_sorted(smallest_sites()));
        EXPECT_EQ(canonical_tetrahedra(tetrahedra), before);
        Points moved = delaunay.sites.coordinates();
        for (SiteId s = 0; s < n; ++s) moved.col(number[s]) = delaunay.sites.coordinates().col(s);
        testing::expect_torus(tetrahedra, moved);
    }
}

}  // namespace
}  // namespace pcvt::space
