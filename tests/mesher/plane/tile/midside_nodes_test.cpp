#include "mesher/plane/tile/midside_nodes.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "mesher/plane/mesh/outline.hpp"
#include "mesher/plane/mesh/voronoi.hpp"
#include "mesher/plane/tile/tile_builder.hpp"
#include "tests/support/lattices.hpp"

namespace pcvt::plane {
namespace {

Tile triangles(const Lattice& lattice, int n) {
    const PeriodicMesh mesh =
        triangle_mesh(PeriodicDelaunay(Sites(lattice, uniform_points(lattice, n, 3))));
    return make_tile(mesh, whole_outline(mesh, {0, 0}));
}

// Law 1.
TEST(MidsideNodes, EachEdgeHasOneNodeThatItsFacesShare) {
    const Tile tile = triangles(Lattice::rectangle(1, 1), 20);
    const MidsideNodes nodes = midside_nodes(tile);
    std::map<std::set<int>, int> node_of;
    for (int c = 0; c < 3 * tile.n_faces(); ++c) {
        const int next = c % 3 == 2 ? c - 2 : c + 1;
        const std::set<int> ends{tile.faces.corners[c], tile.faces.corners[next]};
        const int node = node_of.emplace(ends, nodes.of_corner[c]).first->second;
        EXPECT_EQ(node, nodes.of_corner[c]);
    }
    std::set<int> distinct;
    for (const auto& [ends, node] : node_of) distinct.insert(node);
    EXPECT_EQ(distinct.size(), node_of.size());
    EXPECT_EQ(nodes.points.size(), node_of.size());
    EXPECT_EQ(*distinct.begin(), tile.n_vertices());
    EXPECT_EQ(*distinct.rbegin(), tile.n_vertices() + static_cast<int>(nodes.points.size()) - 1);
}

// Law 2.
TEST(MidsideNodes, NodesOnTheSeamAreRepresentativePlusTranslation) {
    for (const auto& [name, lattice] : testing::lattices()) {
        for (const int n : {1, 2, 25}) {
            SCOPED_TRACE(name);
            const Tile tile = triangles(lattice, n);
            const MidsideNodes nodes = midside_nodes(tile);
            ASSERT_EQ(nodes.pairs.size(), tile.edge_pairs.size());
            for (const VertexPair& pair : nodes.pairs) {
                ASSERT_LT(pair.v, pair.w);
                const Vec2 there =
                    nodes.points[pair.v - tile.n_vertices()] + lattice.translation(pair.offset);
                ASSERT_EQ(nodes.points[pair.w - tile.n_vertices()], there);
            }
        }
    }
}

TEST(MidsideNodes, NodesStandInTheMiddleOfTheirEdges) {
    const Tile tile = triangles(Lattice({1, 0}, {0.37, 0.81}), 25);
    const MidsideNodes nodes = midside_nodes(tile);
    for (int c = 0; c < 3 * tile.n_faces(); ++c) {
        const int next = c % 3 == 2 ? c - 2 : c + 1;
        const Vec2 middle =
            (tile.points[tile.faces.corners[c]] + tile.points[tile.faces.corners[next]]) / 2;
        EXPECT_LT((nodes.points[nodes.of_corner[c] - tile.n_vertices()] - middle).norm(), 1e-15);
    }
    for (std::size_t k = 0; k < tile.edge_pairs.size(); ++k) {
        const EdgePair& pair = tile.edge_pairs[k];
        const Vec2 middle = (tile.points[pair.w0] + tile.points[pair.w1]) / 2;
        const Vec2& node = nodes.points[nodes.of_edge_pair[k][1] - tile.n_vertices()];
        EXPECT_LT((node - middle).norm(), 1e-15);
    }
}

}  // namespace
}  // namespace pcvt::plane
