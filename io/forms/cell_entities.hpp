#pragma once

#include <optional>
#include <vector>

#include "io/forms/solver_nodes.hpp"

namespace pcvt {

/// A chain of edges on which two cells meet, or that bounds the tile.
struct CellCurve {
    /// Both ends included, so two or more; a closed curve ends where it begins.
    std::vector<int> vertices;
    /// For order 2 the nodes between them: middles[k] after vertices[k].
    std::vector<int> middles = {};
    /// Indices of the surfaces on both sides; `right` < 0 where the curve bounds the tile.
    int left;
    int right = -1;
    /// On the seam: the translation to its partner, and the index of that curve, which runs the
    /// other way.
    plane::Offset offset = {};
    int partner = -1;
    /// The wall on which it lies; nothing elsewhere.
    std::optional<plane::WallId> wall = {};

    bool bounds_tile() const { return right < 0; }
    bool is_seam() const { return bounds_tile() && !wall; }
};

/// The triangles of all images of one cell in the tile.
struct CellSurface {
    SiteId site;
    std::vector<int> triangles = {};
    /// Indices of its curves, rising; a curve with the surface on both sides twice.
    std::vector<int> left_of = {};
    std::vector<int> right_of = {};
    /// The nodes inside, which lie on none of its curves.
    std::vector<int> nodes = {};
};

/// The cells of triangles and their boundaries, as entities of Gmsh. Laws, tested by number:
///
///   (1) Two triangles with a common edge belong to one cell, or a curve contains the edge.
///   (2) Curves end at points and contain no other points; the points of the seam are closed under
///       identification. A curve of the tile's boundary has one translation or lies on one wall.
///   (3) Every node is a point, or inside of one curve, or inside of one surface.
struct CellEntities {
    /// The vertex of each point.
    std::vector<int> points;
    /// The seam and the walls first, counter-clockwise; then the boundaries between cells.
    std::vector<CellCurve> curves;
    /// The surfaces of cells by rising site; cells without a triangle have none.
    std::vector<CellSurface> surfaces;
};

/// Example usage:
///     const SolverNodes nodes = solver_nodes(tile);
///     for (const CellSurface& cell : cell_entities(tile, nodes).surfaces) count(cell.triangles);
///
/// @param nodes  solver_nodes() of the tile.
/// @pre the tile consists of triangles and has its edge_pairs and wall_edges.
/// @throws InternalError where its boundary does not consist of loops.
CellEntities cell_entities(const plane::Tile& tile, const SolverNodes& nodes);

}  // namespace pcvt
