#include "mesher/torus_triangulation.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "mesher/error.hpp"
#include "mesher/mirror_diagram.hpp"
#include "tests/support/lattices.hpp"

namespace pcvt {
namespace {

using testing::lattices;

TorusTriangulation triangulation_of(const Lattice& lattice, int n, std::uint64_t seed) {
    const Sites sites(lattice, uniform_points(lattice, n, seed));
    return {n, mirror_diagram(sites).triangles};
}

/// The triangle of h without its frame: corners turned so that the smallest comes first.
std::vector<std::tuple<SiteId, int, int>> frameless(const TorusTriangulation& t, int h) {
    std::vector<std::vector<std::tuple<SiteId, int, int>>> turns;
    for (int k = 0; k < 3; ++k, h = TorusTriangulation::next(h)) {
        std::vector<std::tuple<SiteId, int, int>> corners;
        for (int g = h, m = 0; m < 3; ++m, g = TorusTriangulation::next(g)) {
            const Offset offset = t.corner(g).offset - t.corner(h).offset;
            corners.emplace_back(t.corner(g).site, offset.i, offset.j);
        }
        turns.push_back(corners);
    }
    return *std::min_element(turns.begin(), turns.end());
}

std::vector<std::vector<std::tuple<SiteId, int, int>>> triangle_set(const TorusTriangulation& t) {
    std::vector<std::vector<std::tuple<SiteId, int, int>>> set;
    for (int h = 0; h < t.n_halfedges(); h += 3) set.push_back(frameless(t, h));
    std::sort(set.begin(), set.end());
    return set;
}

// Laws 1 to 3.
void expect_laws(const TorusTriangulation& t) {
    ASSERT_EQ(t.n_triangles(), 2 * t.n_sites());
    for (int h = 0; h < t.n_halfedges(); ++h) {
        const int o = t.opposite(h);
        ASSERT_NE(o, h);
        ASSERT_EQ(t.opposite(o), h);
        ASSERT_EQ(t.edge_offset(o), -t.edge_offset(h));
        ASSERT_EQ(t.corner(o).site, t.corner(TorusTriangulation::next(h)).site);
        ASSERT_EQ(t.frame_across(o), -t.frame_across(h));
    }
}

TEST(TorusTriangulation, LawsHoldFromOneSiteOn) {
    for (const auto& [name, lattice] : lattices()) {
        for (const int n : {1, 2, 3, 4, 5, 6, 7, 8, 100}) {
            SCOPED_TRACE(name + " n = " + std::to_string(n));
            expect_laws(triangulation_of(lattice, n, 1));
        }
    }
}

// Law 4, and that laws 1 to 3 survive any flips: a flip is combinatorial, geometry does not matter.
TEST(TorusTriangulation, FlipsKeepTheLawsAndUndoThemselves) {
    for (const int n : {1, 2, 3, 5, 20}) {
        TorusTriangulation t = triangulation_of(Lattice({1, 0}, {0.37, 0.81}), n, 2);
        for (int h = 0; h < t.n_halfedges(); ++h) {
            SCOPED_TRACE("n = " + std::to_string(n) + " h = " + std::to_string(h));
            const auto before = triangle_set(t);
            t.flip(h);
            expect_laws(t);
            ASSERT_NE(triangle_set(t), before);
            t.flip(h);
            ASSERT_EQ(triangle_set(t), before);
        }
    }
}

TEST(TorusTriangulation, RefusesTrianglesThatDoNotClose) {
    const Sites sites(Lattice::rectangle(1, 1), uniform_points(Lattice::rectangle(1, 1), 5, 1));
    auto triangles = mirror_diagram(sites).triangles;
    triangles[3][1].offset.i += 1;
    EXPECT_THROW(TorusTriangulation(5, triangles), InternalError);
    triangles.pop_back();
    EXPECT_THROW(TorusTriangulation(5, triangles), InternalError);
}

}  // namespace
}  // namespace pcvt
