#include "tests/support/solver_tiles.hpp"

#include <gtest/gtest.h>

#include "tests/support/grid_tile.hpp"
#include "tests/support/tile_equality.hpp"

namespace pcvt::testing {
namespace {

plane::Tile as_grains(plane::Tile tile) {
    tile.kind = plane::MeshKind::kGrains;
    tile.vertex_site.clear();
    for (int f = 0; f < tile.n_faces(); ++f) tile.face_site.push_back(f / 3);
    return tile;
}

}  // namespace

std::vector<plane::Tile> solver_tiles(const std::vector<plane::Lattice>& lattices) {
    std::vector<plane::Tile> tiles;
    for (const plane::Lattice& lattice : lattices) {
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

void expect_read_back(const TileFile& file, const plane::Tile& written) {
    EXPECT_EQ(file.precision, plane::Precision::kDouble);
    EXPECT_EQ(file.tile.order, written.order);
    const plane::TileProof proof = prove_tile(file.tile, plane::Precision::kDouble);
    ASSERT_TRUE(file.has_vertex_pairs);
    EXPECT_NO_THROW(compare_vertex_pairs(file.tile, proof));
    if (file.has_edge_pairs) {
        EXPECT_NO_THROW(compare_edge_pairs(file.tile, proof));
    }
    plane::Tile plain = written;
    plain.vertex_pairs = file.tile.vertex_pairs;
    plain.edge_pairs = file.tile.edge_pairs;
    expect_same_tile(file.tile, plain);
}

}  // namespace pcvt::testing
