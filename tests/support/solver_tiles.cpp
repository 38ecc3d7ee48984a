#include "tests/support/solver_tiles.hpp"

#include <gtest/gtest.h>

#include "tests/support/flat_tile_equality.hpp"
#include "tests/support/grid_tile.hpp"

namespace pcvt::testing {
namespace {

FlatTile as_grains(FlatTile tile) {
    tile.kind = TileKind::kGrains;
    tile.vertex_site.clear();
    for (int f = 0; f < tile.n_faces(); ++f) tile.face_site.push_back(f / 3);
    return tile;
}

}  // namespace

std::vector<FlatTile> solver_tiles(const std::vector<Lattice>& lattices) {
    std::vector<FlatTile> tiles;
    for (const Lattice& lattice : lattices) {
        for (const auto& [columns, rows] : {std::pair(1, 1), std::pair(3, 2), std::pair(2, 5)}) {
            tiles.push_back(triangle_grid_tile(lattice, columns, rows));
            tiles.push_back(as_grains(tiles.back()));
            for (int k = 0; k < 2; ++k) {
                tiles.push_back(*(tiles.end() - 2));
                tiles.back().order = 2;
            }
        }
    }
    return tiles;
}

void expect_read_back(const TileFile& file, const FlatTile& written) {
    EXPECT_EQ(file.precision, Precision::kDouble);
    EXPECT_EQ(file.tile.order, written.order);
    const TileProof proof = prove_tile(file.tile, Precision::kDouble);
    ASSERT_TRUE(file.has_vertex_pairs);
    EXPECT_NO_THROW(compare_vertex_pairs(file.tile, proof));
    if (file.has_edge_pairs) {
        EXPECT_NO_THROW(compare_edge_pairs(file.tile, proof));
    }
    FlatTile plain = written;
    plain.vertex_pairs = file.tile.vertex_pairs;
    plain.edge_pairs = file.tile.edge_pairs;
    expect_same_tile(file.tile, plain);
}

}  // namespace pcvt::testing
