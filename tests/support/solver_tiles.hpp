#pragma once

#include <vector>

#include "io/forms/tile_file.hpp"

namespace pcvt::testing {

/// Tiles of triangles on awkward lattices: Delaunay triangles and grains, of order 1 and 2.
std::vector<plane::Tile> solver_tiles(const std::vector<plane::Lattice>& lattices);

/// Expects that the tile read from a file has the points, faces, sites and order of `written`, bit
/// for bit, and that its stored pairs are equivalent to the pairs of its positions.
void expect_read_back(const TileFile& file, const plane::Tile& written);

}  // namespace pcvt::testing
