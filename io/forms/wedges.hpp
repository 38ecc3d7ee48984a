#pragma once

#include <array>
#include <span>
#include <vector>

#include "io/forms/element_mesh.hpp"
#include "io/forms/triangle_cells.hpp"

namespace pcvt {

/// The nodes of one layer of wedges: those of the triangles at z = 0, the same ones at the top,
/// and, of order 2, one in the middle of the edge above each corner.
///
/// Example usage:
///     const WedgeNodes nodes{.n_layer = 40, .n_corners = 12, .order = 2};
///     assert(nodes.at_top(7) == 47 && nodes.column(nodes.in_middle(7)) == 7);
struct WedgeNodes {
    /// The nodes of the triangles, of which the first n_corners are corners.
    int n_layer;
    int n_corners;
    int order;

    int n_nodes() const { return 2 * n_layer + (order == 2 ? n_corners : 0); }
    int at_top(int v) const { return v + n_layer; }
    /// @pre v < n_corners, and order is 2.
    int in_middle(int v) const { return v + 2 * n_layer; }
    /// The node of the triangles below a node.
    int column(int node) const { return node % n_layer; }
    bool is_at_top(int node) const { return node / n_layer == 1; }
    /// The height of a node.
    double height(int node, double thickness) const {
        return std::array{0.0, thickness, thickness / 2}[static_cast<std::size_t>(node / n_layer)];
    }
    /// The wedge over a triangle with three or six nodes, in the order of ElementType.
    std::vector<int> wedge(std::span<const int> triangle) const;
};

/// Extrudes triangles to one layer of wedges that is periodic along z as well. Laws, tested by
/// number:
///   (1) The nodes are those of WedgeNodes; the periods are those of the triangles, and
///       (0, 0, thickness).
///   (2) A node at the top has the representative of the node below it, with the offset 1 along z;
///       a node in the middle that of the middle above the representative of its column.
///   (3) Each wedge has the volume of its triangle times the thickness.
///
/// @param triangles  element_mesh() of a tile of triangles.
/// @param n_corners  the number of vertices of the tile.
ElementMesh wedge_mesh(const ElementMesh& triangles, int n_corners, double thickness);

/// An edge of a tile of triangles on both of its faces.
struct SharedEdge {
    /// The faces, and the number of the corner of each at which the edge begins, from 0 to 2.
    std::array<int, 2> faces;
    std::array<int, 2> sides;
    /// Whether the faces lie in different cells, or in different images of one cell.
    bool is_between_cells;
};

/// Returns each edge of the torus once: edges on walls and at holes are left out.
/// @param cells  of the tile.
std::vector<SharedEdge> shared_edges(const plane::Tile& tile, const TriangleCells& cells);

}  // namespace pcvt
