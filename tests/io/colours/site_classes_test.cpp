#include "io/colours/site_classes.hpp"

#include <gmock/gmock.h>

#include <map>
#include <set>
#include <utility>

#include "mesher/plane/tile/build_tile.hpp"

namespace pcvt {
namespace {

using ::testing::Each;
using ::testing::Ge;
using ::testing::Le;

plane::Tile random_tile(const plane::Lattice& lattice, int n, const plane::TileOptions& options) {
    return build_tile(plane::PeriodicDelaunay(plane::Sites(lattice, uniform_points(lattice, n, 1))),
                      options)
        .tile;
}

/// Calls visit(face, its edge) for each edge of each face.
template <class Visit>
void for_each_edge(const plane::Tile& tile, const Visit& visit) {
    for (int f = 0; f < tile.n_faces(); ++f) {
        int previous = tile.faces[f].back();
        for (const int v : tile.faces[f]) visit(f, std::exchange(previous, v), v);
    }
}

/// Expects that faces of different sites, or groups of sites, with a common edge differ, inside and
/// across the seam.
void expect_neighbours_differ(const plane::Tile& tile, const std::vector<int>& site_group = {}) {
    const std::vector<int> classes = site_classes(tile, site_group);
    const auto group = [&](int f) {
        return site_group.empty() ? tile.face_site[f] : site_group[tile.face_site[f]];
    };
    std::map<int, int> class_of_group;
    for (int f = 0; f < tile.n_faces(); ++f) {
        EXPECT_EQ(class_of_group.emplace(group(f), classes[f]).first->second, classes[f]);
    }
    ASSERT_EQ(classes.size(), std::size_t(tile.n_faces()));
    EXPECT_THAT(classes, Each(::testing::AllOf(Ge(0), Le(kSiteClasses - 1))));
    std::map<std::pair<int, int>, int> face_left_of;
    for_each_edge(tile, [&](int f, int v, int w) { face_left_of[{v, w}] = f; });
    const auto expect = [&](int f, int g) {
        if (group(f) == group(g)) return;
        EXPECT_NE(classes[f], classes[g]) << group(f) << " " << group(g);
    };
    for_each_edge(tile, [&](int f, int v, int w) {
        const auto other = face_left_of.find({w, v});
        if (other != face_left_of.end()) expect(f, other->second);
    });
    for (const plane::EdgePair& pair : tile.edge_pairs) {
        expect(face_left_of.at({pair.v0, pair.v1}), face_left_of.at({pair.w1, pair.w0}));
    }
}

TEST(SiteClasses, NeighboursDifferAcrossTheSeamAsWell) {
    for (const plane::Lattice& lattice :
         {plane::Lattice::rectangle(1, 1), plane::Lattice({1, 0}, {0.37, 0.81})}) {
        for (const int n : {1, 2, 3, 4, 5, 6, 7, 8, 30, 200}) {
            expect_neighbours_differ(random_tile(lattice, n, {}));
            expect_neighbours_differ(random_tile(lattice, n, {.outline = plane::Outline::kBox}));
            expect_neighbours_differ(random_tile(lattice, n, {.kind = plane::MeshKind::kGrains}));
            expect_neighbours_differ(random_tile(lattice, n, {.repeat = {2, 3}}));
        }
    }
}

/// Sites that a translation by a third of a period maps to each other are a group.
TEST(SiteClasses, GroupsOfSitesHaveOneClassAndDifferFromTheirNeighbours) {
    const plane::Lattice lattice({1.5, 0}, {0.3, 0.8});
    for (const int n : {1, 2, 3, 5, 8, 40}) {
        const plane::Points third = uniform_points(plane::Lattice({0.5, 0}, {0.3, 0.8}), n, 1);
        plane::Points points(2, 3 * n);
        std::vector<int> group;
        for (int s = 0; s < 3 * n; ++s) {
            points.col(s) = third.col(s % n) + plane::Vec2(0.5 * (s / n), 0);
            group.push_back(s % n);
        }
        for (const plane::MeshKind kind : {plane::MeshKind::kVoronoi, plane::MeshKind::kGrains}) {
            const plane::PeriodicDelaunay delaunay(plane::Sites(lattice, points));
            expect_neighbours_differ(build_tile(delaunay, {.kind = kind}).tile, group);
            expect_neighbours_differ(build_tile(delaunay, {.kind = kind, .repeat = {1, 2}}).tile,
                                     group);
        }
    }
}

TEST(SiteClasses, SitesOfATriangleDiffer) {
    const plane::Tile tile =
        random_tile(plane::Lattice::rectangle(1, 1), 60, {.kind = plane::MeshKind::kDelaunay});
    const std::vector<int> classes = site_classes(tile);
    ASSERT_EQ(classes.size(), tile.points.size());
    for (int f = 0; f < tile.n_faces(); ++f) {
        const auto corners = tile.faces[f];
        const std::set<int> of_face{classes[corners[0]], classes[corners[1]], classes[corners[2]]};
        EXPECT_EQ(of_face.size(), 3u);
    }
    for (const plane::VertexPair& pair : tile.vertex_pairs)
        EXPECT_EQ(classes[pair.v], classes[pair.w]);
}

TEST(SiteClasses, EachClassHasAboutAsManySites) {
    std::map<int, int> n_sites;
    for (const int k : site_classes(random_tile(plane::Lattice::rectangle(1, 1), 700, {})))
        ++n_sites[k];
    for (int k = 0; k < kSiteClasses; ++k)
        EXPECT_THAT(n_sites[k], ::testing::AllOf(Ge(70), Le(130)));
}

}  // namespace
}  // namespace pcvt
