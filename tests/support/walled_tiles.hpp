#pragma once

#include <vector>

#include "mesher/lattice/walls.hpp"
#include "mesher/tile/build_tile.hpp"

namespace pcvt::testing {

/// A tile of about half a dozen cells, or of more, in the rectangle 2 x 1 with walls.
Tile walled_tile(Walls walls, WallCells cells, int n, TileOptions options);

/// Tiles of triangles with these walls: grains of both outlines and orders and of one cell, and
/// Delaunay triangles of half cells.
std::vector<Tile> walled_tiles(Walls walls);

}  // namespace pcvt::testing
