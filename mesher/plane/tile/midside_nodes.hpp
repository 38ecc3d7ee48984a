#pragma once

#include <array>

#include "mesher/plane/tile/tile.hpp"

namespace pcvt::plane {

/// The nodes in the middle of the edges of a tile, by which its triangles become six-node triangles
/// with straight sides. They are numbered on from the vertices of the tile.
///
/// Laws, tested by number:
///   (1) Each edge of the tile has one node, and the two faces at an edge share it.
///   (2) Of the two nodes on an edge of the seam one is the representative, in the middle of its
///       edge; the other one is the representative + translation, computed once.
struct MidsideNodes {
    /// points[k] is the position of node n_vertices() + k, length units.
    std::vector<Vec2> points;
    /// For each corner of the tile the node between it and the next corner of its face.
    std::vector<int> of_corner;
    /// For each edge pair of the tile the nodes on v0 v1 and on w0 w1.
    std::vector<std::array<int, 2>> of_edge_pair;
    /// For each wall edge of the tile the node on it.
    std::vector<int> of_wall_edge;
    /// As Tile::vertex_pairs: one pair for each node w that is not the representative v.
    std::vector<VertexPair> pairs;
};

/// @pre the edge pairs and the wall edges of the tile are filled.
MidsideNodes midside_nodes(const Tile& tile);

}  // namespace pcvt::plane
