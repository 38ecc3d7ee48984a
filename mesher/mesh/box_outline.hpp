#pragma once

#include "mesher/mesh/periodic_mesh.hpp"

namespace pcvt {

/// Cells cut along the parallelogram of the period vectors.
struct BoxCut {
    /// The pieces (`kVoronoi`), each with the site of its cell: with every face in its own frame
    /// they fill the parallelogram with its corner at the origin of the cut.
    PeriodicMesh pieces;
    /// Length units: the shortest edge that ends on the cut or lies on it.
    double shortest_edge;
};

/// The `box` outline: each cell cut along the lines origin + k a + t b and origin + l b + t a.
///
/// A cell may give several pieces. Vertices nearer to a line than `snap` are moved onto it, and
/// edges nearer to a corner of the box than kSameVertex h (sites.hpp) pass through it: where cell
/// edges lie on the cut, they become part of it. Laws, tested by number:
///   (1) The pieces are a mesh of the same torus: V - E + F = 0, the areas sum to that of the
///       domain, and each piece lies within the box.
///   (2) A vertex on the left or lower side, corners included, is the representative of its orbit;
///       the one on the opposite side is its translate.
///   (3) The pieces of a cell, each moved back by a lattice vector, make up the cell but for
///   `snap`.
///
/// @param cells   whole cells (`kVoronoi`); they need not be convex.
/// @param origin  corner of the box, length units.
/// @param snap    length units; no less than kSameVertex h is taken. Where it would
///                tear a cell, less is taken.
BoxCut cut_along_box(const PeriodicMesh& cells, const Vec2& origin, double snap = 0);

}  // namespace pcvt
