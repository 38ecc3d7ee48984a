#pragma once

#include <array>
#include <optional>
#include <vector>

#include "mesher/plane/geometry/sites.hpp"

namespace pcvt {

struct FileTileBuilder;

/// Items of a solver's file under the numbers that the file gives them, in any order and with gaps.
/// Each item holds its line.
struct NumberedItems {
    struct Node {
        int number;
        int line;
        plane::Vec2 point;
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
        plane::Vec2 translation;
    };
    /// A boundary edge, the tile on its left, and the nodes that its partner joins: as EdgePair.
    struct Edge {
        std::array<int, 4> nodes;
        /// The node in its middle; nothing for order 1.
        std::optional<int> middle;
        int line;
        plane::Vec2 translation;
    };
    /// The site of the node or triangle with this number.
    struct SiteOf {
        int number;
        int line;
        SiteId site;
    };

    std::vector<Node> nodes = {};
    std::vector<Triangle> triangles = {};
    std::vector<Link> links = {};
    std::vector<Edge> edges = {};
    /// The sites of the nodes of a Delaunay tile, or of the triangles where their cells own them.
    std::vector<SiteOf> node_sites = {};
    std::vector<SiteOf> triangle_sites = {};
};

/// Moves the numbered items of `builder` to its vertices, faces, sites and pairs, in the order of
/// their numbers; finish() calls it.
/// @param lattice  replaces one that the file lacks.
/// @throws BadFile  with the line, as finish() states.
void resolve_numbers(FileTileBuilder& builder, const std::optional<plane::Lattice>& lattice);

}  // namespace pcvt
