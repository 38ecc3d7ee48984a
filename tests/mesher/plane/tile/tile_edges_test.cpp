#include "mesher/plane/tile/tile_edges.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "mesher/plane/mesh/outline.hpp"
#include "mesher/plane/mesh/voronoi.hpp"
#include "mesher/plane/tile/tile_builder.hpp"
#include "tests/support/example_lattices.hpp"
#include "tests/support/grid_tile.hpp"

namespace pcvt::plane {
namespace {

using testing::kOblique;

std::vector<Tile> oblique_tiles() {
    const PeriodicMesh cells =
        cell_mesh(PeriodicDelaunay(Sites(kOblique, uniform_points(kOblique, 40, 5))));
    return {testing::grid_tile(kOblique, 1, 1), testing::grid_tile(kOblique, 4, 3),
            testing::triangle_grid_tile(kOblique, 3, 2),
            make_tile(cells, whole_outline(cells, {}))};
}

TEST(TileEdges, HaveEachEdgeOnce) {
    for (const Tile& tile : oblique_tiles()) {
        std::set<std::set<int>> expected;
        for (int f = 0; f < tile.n_faces(); ++f) {
            int from = tile.faces[f].back();
            for (const int to : tile.faces[f]) {
                expected.insert({from, to});
                from = to;
            }
        }
        std::set<std::set<int>> found;
        for (const TileEdge& edge : tile_edges(tile)) {
            EXPECT_TRUE(found.insert({edge.v, edge.w}).second) << edge.v << " " << edge.w;
        }
        EXPECT_EQ(found, expected);
        // Euler's formula of a disc.
        EXPECT_EQ(std::ssize(found), tile.n_vertices() + tile.n_faces() - 1);
    }
}

TEST(TileEdges, NameTheFacesOfBothSides) {
    for (const Tile& tile : oblique_tiles()) {
        std::map<std::pair<int, int>, int> face_of;
        for (int f = 0; f < tile.n_faces(); ++f) {
            int from = tile.faces[f].back();
            for (const int to : tile.faces[f]) {
                face_of[{from, to}] = f;
                from = to;
            }
        }
        std::size_t n_seam = 0;
        for (const TileEdge& edge : tile_edges(tile)) {
            EXPECT_EQ(edge.left, face_of.at({edge.v, edge.w}));
            n_seam += edge.on_seam;
            if (edge.on_seam) continue;
            EXPECT_EQ(edge.right, face_of.at({edge.w, edge.v}));
        }
        EXPECT_EQ(n_seam, 2 * tile.edge_pairs.size());
    }
}

TEST(TileEdges, AcrossTheSeamLiesTheFaceOfThePartner) {
    // Cells of a 3 x 2 grid lie row by row.
    const Tile tile = testing::grid_tile(kOblique, 3, 2);
    for (const TileEdge& edge : tile_edges(tile)) {
        const int step = std::abs(edge.left - edge.right);
        // The seam joins columns 0 and 2, or rows 0 and 1.
        EXPECT_TRUE(step == 3 || step == (edge.on_seam ? 2 : 1)) << edge.left << " " << edge.right;
    }
}

}  // namespace
}  // namespace pcvt::plane
