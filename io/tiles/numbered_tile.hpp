#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "io/tiles/raw_tile.hpp"

namespace pcvt {

/// What the readers of solvers' formats gather: items under the numbers that the file gives them,
/// in any order and with gaps. Each item knows its line.
struct NumberedTile {
    struct Node {
        int number;
        int line;
        Vec2 point;
    };
    struct Triangle {
        int number;
        int line;
        std::vector<int> nodes;
    };
    /// position(slave) = position(master) + translation.
    struct Link {
        int slave;
        int master;
        int line;
        Vec2 translation;
    };
    /// A boundary edge, the tile on its left, and the nodes that its partner joins: as EdgePair.
    struct Edge {
        std::array<int, 4> nodes;
        /// The node in its middle; nothing for order 1.
        std::optional<int> middle;
        int line;
        Vec2 translation;
    };
    /// The site of the node or triangle with this number.
    struct SiteOf {
        int number;
        int line;
        SiteId site;
    };

    /// name, kind, lattice and sites that need no numbers are filled by the reader, the rest by
    /// finish().
    RawTile raw;
    std::vector<Node> nodes;
    std::vector<Triangle> triangles;
    std::vector<Link> links;
    std::vector<Edge> edges;
    /// Of the nodes of a Delaunay tile, or of the triangles where their cells own them.
    std::vector<SiteOf> node_sites;
    std::vector<SiteOf> triangle_sites;
};

/// Vertices and faces in the order of their numbers, as a tile; of six-node triangles the nodes in
/// the middle of edges are proved and left out.
/// @param lattice  stands in for one that the file lacks.
/// @throws BadFile  with the line: a number given twice or used but not given; a translation that
///                  is no lattice vector within 4 ulps; and what finish() of a RawTile refuses.
TileFile finish(NumberedTile numbered, const std::optional<Lattice>& lattice);

}  // namespace pcvt
