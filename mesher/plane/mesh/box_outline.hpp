#pragma once

#include <optional>

#include "mesher/plane/mesh/box_lines.hpp"
#include "mesher/plane/mesh/periodic_mesh.hpp"

namespace pcvt::plane {

/// The cells, cut along the parallelogram of the period vectors.
struct BoxCut {
    /// The pieces (`kVoronoi`), each with the site of its cell. With every face in its own frame
    /// they fill the parallelogram with its corner at the origin of the cut.
    PeriodicMesh pieces;
    /// The length of the shortest edge that lies on the cut or ends on it, length units.
    double shortest_edge;
    /// The vertices and edges that were moved.
    BoxSnaps snaps;
};

/// Computes the `box` outline: cuts each cell along the lines origin + k a + t b and origin + l b +
/// t a.
///
/// Example usage:
///   const PeriodicMesh cells = cell_mesh(delaunay);
///   const PeriodicMesh pieces = cut_along_box(cells, find_box_origin(cells)).pieces;
///
/// A cell may be cut into several pieces. Vertices nearer to a line than `snap` are moved onto it,
/// and an edge nearer to a corner of the box than `snap` is bent so that it passes through it. Cell
/// edges that lie on the cut therefore become part of it. Laws, tested by number:
///   (1) The pieces are a mesh of the same torus: V - E + F = 0, the areas sum to that of the
///       domain, and each piece lies within the box.
///   (2) A vertex on the left or lower side, corners included, is the representative of its orbit;
///       the vertex on the opposite side is its translate.
///   (3) The pieces of a cell, each moved back by a lattice vector, make up the cell up to `snap`.
///   (4) After an earlier cut, the vertices and edges that it moved are moved again within
///       kHeldSnap snap of the box, and all others only within snap / 3, so that the same few are
///       moved.
///
/// @param cells   whole cells (`kVoronoi`); they need not be convex.
/// @param origin  corner of the box, length units.
/// @param snap    length units; at least kSameVertex h is used. A distance that would tear a cell
///                is reduced.
/// @param earlier the vertices and edges that an earlier cut of cells of the same topology moved,
///                and the vertices that stay where they are.
BoxCut cut_along_box(const PeriodicMesh& cells, const Vec2& origin, double snap = 0,
                     const BoxSnaps& earlier = {});

/// Computes the cut of cells that moves the same vertices and edges as the cut of other cells of
/// the same topology, so that the areas of the pieces are continuous functions of the vertices.
/// @returns nothing if a piece has no area. Pieces may cross themselves.
std::optional<BoxCut> cut_along_box_as_before(const PeriodicMesh& cells, const Vec2& origin,
                                              const BoxSnaps& earlier);

}  // namespace pcvt::plane
