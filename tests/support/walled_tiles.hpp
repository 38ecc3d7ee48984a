#pragma once

#include <vector>

#include "mesher/plane/geometry/walls.hpp"
#include "mesher/plane/tile/build_tile.hpp"

namespace pcvt::testing {

/// A tile of about half a dozen cells, or of more, in the rectangle 2 x 1 with walls.
plane::Tile walled_tile(plane::Walls walls, plane::WallCells cells, int n,
                        plane::TileOptions options);

/// Tiles of triangles with these walls: grains of both outlines and orders and of one cell, and
/// Delaunay triangles of half cells.
std::vector<plane::Tile> walled_tiles(plane::Walls walls);

}  // namespace pcvt::testing
