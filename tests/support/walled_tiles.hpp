#pragma once

#include <vector>

#include "mesher/plane/tile/build_tile.hpp"
#include "mesher/torus/walls.hpp"

namespace pcvt::testing {

/// A tile of about half a dozen cells, or of more, in the rectangle 2 x 1 with walls.
plane::Tile walled_tile(Walls walls, WallCells cells, int n, plane::TileOptions options);

/// Tiles of triangles with these walls: grains of both outlines and orders and of one cell, and
/// Delaunay triangles of half cells.
std::vector<plane::Tile> walled_tiles(Walls walls);

}  // namespace pcvt::testing
