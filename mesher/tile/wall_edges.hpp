#pragma once

#include "mesher/tile/tile.hpp"

namespace pcvt {

/// Returns the sides of faces whose ends lie on one wall, within the rounding of single precision,
/// sorted: the edges on walls of a tile that obeys its laws. Copies of vertices count as the
/// vertices that they repeat.
///
/// Example usage:
///   tile.wall_edges = edges_on_walls(tile);  // of a file that states the walls alone
std::vector<WallEdge> edges_on_walls(const Tile& tile);

}  // namespace pcvt
