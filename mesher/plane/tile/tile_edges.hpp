#pragma once

#include <vector>

#include "mesher/plane/tile/tile.hpp"

namespace pcvt::plane {

/// An edge of a tile: face `left` runs from v to w along it, face `right` from w to v. On the seam
/// `right` lies across it, at the partner of the edge; on a wall `right` is -1.
struct TileEdge {
    int v;
    int w;
    int left;
    int right;
    bool on_seam;
};

/// Returns each edge of a tile once, sorted by its smaller and then its larger vertex. Both edges
/// of a pair of the seam are edges of the tile. Cost: O(n log n).
///
/// Example usage:
///   for (const TileEdge& edge : tile_edges(tile)) length += (p[edge.w] - p[edge.v]).norm();
/// @pre the tile obeys its laws (mesher/plane/proof).
std::vector<TileEdge> tile_edges(const Tile& tile);

/// Returns the sides of faces whose ends lie on one wall, within the rounding of single precision,
/// sorted: the edges on walls of a tile that obeys its laws. Copies of vertices count as the
/// vertices that they repeat.
///
/// Example usage:
///   tile.wall_edges = edges_on_walls(tile);  // of a file that states only the walls
std::vector<WallEdge> edges_on_walls(const Tile& tile);

}  // namespace pcvt::plane
