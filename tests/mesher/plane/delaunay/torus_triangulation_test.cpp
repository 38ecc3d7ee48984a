#include "mesher/plane/delaunay/torus_triangulation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "mesher/base/error.hpp"
#include "mesher/plane/delaunay/mirror_diagram.hpp"
#include "tests/support/lattices.hpp"
#include "tests/support/triangulation_laws.hpp"

namespace pcvt::plane {
namespace {

using testing::expect_laws;
using testing::lattices;

TorusTriangulation triangulation_of(const Lattice& lattice, int n, std::uint64_t seed) {
    const Sites sites(lattice, uniform_points(lattice, n, seed));
    return {n, mirror_diagram(sites).triangles};
}

/// The triangle of h independent of its frame: corners rotated so that the smallest comes first.
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

std::vector<std::vector<std::tuple<SiteId, int, int>>> frameless_triangles(
    const TorusTriangulation& t) {
    std::vector<std::vector<std::tuple<SiteId, int, int>>> set;
    for (int h = 0; h < t.n_halfedges(); h += 3) set.push_back(frameless(t, h));
    std::sort(set.begin(), set.end());
    return set;
}

// Laws 1 to 3.
TEST(TorusTriangulation, LawsHoldForAnyNumberOfSites) {
    for (const auto& [name, lattice] : lattices()) {
        for (const int n : {1, 2, 3, 4, 5, 6, 7, 8, 100}) {
            SCOPED_TRACE(name + " n = " + std::to_string(n));
            expect_laws(triangulation_of(lattice, n, 1));
        }
    }
}

// Law 4, and laws 1 to 3 after any flips: a flip is combinatorial and independent of geometry.
TEST(TorusTriangulation, FlipsKeepTheLawsAndAreReversible) {
    for (const int n : {1, 2, 3, 5, 20}) {
        TorusTriangulation t = triangulation_of(Lattice({1, 0}, {0.37, 0.81}), n, 2);
        for (int h = 0; h < t.n_halfedges(); ++h) {
            SCOPED_TRACE("n = " + std::to_string(n) + " h = " + std::to_string(h));
            const auto before = frameless_triangles(t);
            t.flip(h);
            expect_laws(t);
            ASSERT_NE(frameless_triangles(t), before);
            t.flip(h);
            ASSERT_EQ(frameless_triangles(t), before);
        }
    }
}

TEST(TorusTriangulation, TheFrameOfATriangleIsItsCornerZero) {
    const TorusTriangulation t = triangulation_of(Lattice::rectangle(20, 1), 30, 3);
    int n_with_offsets = 0;
    for (int h = 0; h < t.n_halfedges(); ++h) {
        const int first = h - h % 3;
        ASSERT_EQ(t.corner(first).offset, Offset());
        const bool zero =
            t.corner(first + 1).offset == Offset() && t.corner(first + 2).offset == Offset();
        ASSERT_EQ(t.has_offsets(h), !zero);
        n_with_offsets += !zero;
    }
    EXPECT_GT(n_with_offsets, 0);
    EXPECT_LT(n_with_offsets, t.n_halfedges());
}

TEST(TorusTriangulation, OffsetsFollowSitesThatChangeTheirImage) {
    std::mt19937_64 random(4);
    const auto digit = [&] { return static_cast<int>(random() % 21) - 10; };
    for (const int n : {1, 2, 3, 20}) {
        const TorusTriangulation before = triangulation_of(Lattice({1, 0}, {7, 1}), n, 4);
        std::vector<Offset> change(static_cast<std::size_t>(n));
        for (Offset& offset : change) offset = {digit(), digit()};
        TorusTriangulation after = before;
        after.add_to_offsets(change);
        expect_laws(after);
        for (int h = 0; h < before.n_halfedges(); ++h) {
            const Offset origin = change[before.corner(h).site];
            const Offset target = change[before.corner(TorusTriangulation::next(h)).site];
            ASSERT_EQ(after.edge_offset(h), before.edge_offset(h) + target - origin);
            ASSERT_EQ(after.corner(h).site, before.corner(h).site);
        }
    }
}

TEST(TorusTriangulation, RenumberingChangesOnlyTheNumbers) {
    const TorusTriangulation before = triangulation_of(Lattice::rectangle(1, 1), 6, 5);
    TorusTriangulation after = before;
    const std::vector<SiteId> number{3, 5, 0, 1, 4, 2};
    after.renumber_sites(number);
    expect_laws(after);
    for (int h = 0; h < before.n_halfedges(); ++h) {
        ASSERT_EQ(after.corner(h).site, number[before.corner(h).site]);
        ASSERT_EQ(after.corner(h).offset, before.corner(h).offset);
        ASSERT_EQ(after.opposite(h), before.opposite(h));
    }
}

/// The offset of one site in the interior changes, where all triangles round it have none.
TorusTriangulation with_middle_site_moved(Offset change) {
    const Lattice unit = Lattice::rectangle(1, 1);
    Points points = uniform_points(unit, 200, 6);
    points.col(0) << 0.5, 0.5;
    TorusTriangulation t(200, mirror_diagram(Sites(unit, points)).triangles);
    std::vector<Offset> changes(200);
    changes[0] = change;
    t.add_to_offsets(changes);
    return t;
}

TEST(TorusTriangulation, OffsetsBeyond127AreRejected) {
    for (const int far : {127, -127}) {
        expect_laws(with_middle_site_moved({far, 0}));
        expect_laws(with_middle_site_moved({0, far}));
    }
    for (const int far : {129, -129, 256, 1 << 20}) {
        EXPECT_THROW(with_middle_site_moved({far, 0}), InternalError);
        EXPECT_THROW(with_middle_site_moved({0, far}), InternalError);
    }
    const std::vector<Triangle> far{{Corner{0, {}}, Corner{0, {1, 0}}, Corner{0, {200, 1}}},
                                    {Corner{0, {}}, Corner{0, {200, 1}}, Corner{0, {199, 1}}}};
    EXPECT_THROW(TorusTriangulation(1, far), InternalError);
}

// Each flip replaces the longest edge by a longer one.
TEST(TorusTriangulation, AFlipBeyond127IsRejected) {
    TorusTriangulation t = triangulation_of(Lattice::rectangle(1, 1), 1, 7);
    const auto flip_round = [&t] {
        for (int h = 0; h < 1000; ++h) t.flip(h % 3);
    };
    EXPECT_THROW(flip_round(), InternalError);
}

TEST(TorusTriangulation, TakesGivenLinksUnchanged) {
    const Sites sites(Lattice::rectangle(1, 1), uniform_points(Lattice::rectangle(1, 1), 5, 1));
    const auto triangles = mirror_diagram(sites).triangles;
    const TorusTriangulation matched(5, triangles);
    std::vector<int> links;
    for (int h = 0; h < matched.n_halfedges(); ++h) links.push_back(matched.opposite(h));
    const auto sites_of = matched.corner_sites();
    const auto offsets = matched.corner_offsets();
    const TorusTriangulation linked(5, {sites_of.begin(), sites_of.end()},
                                    {offsets.begin(), offsets.end()}, links);
    expect_laws(linked);
    EXPECT_EQ(frameless_triangles(linked), frameless_triangles(matched));
}

TEST(TorusTriangulation, RejectsTrianglesThatDoNotClose) {
    const Sites sites(Lattice::rectangle(1, 1), uniform_points(Lattice::rectangle(1, 1), 5, 1));
    auto triangles = mirror_diagram(sites).triangles;
    triangles[3][1].offset.i += 1;
    EXPECT_THROW(TorusTriangulation(5, triangles), InternalError);
    triangles.pop_back();
    EXPECT_THROW(TorusTriangulation(5, triangles), InternalError);
}

}  // namespace
}  // namespace pcvt::plane
