#pragma once

#include "mesher/plane/mesh/periodic_mesh.hpp"

namespace pcvt::plane {

/// Finds an origin for cut_along_box (box_outline.hpp) that avoids short edges on the cut.
///
/// Example usage:
///   const PeriodicMesh cells = cell_mesh(delaunay);
///   const BoxCut box = cut_along_box(cells, find_box_origin(cells));
///
/// On the torus the origin of the cut is free. The search computes the shortest edge that the cut
/// makes for a few hundred positions of each family of lines, pairs the best positions, and refines
/// the best pair in steps of decreasing size. The result is good but not proved optimal. Equal
/// cells give equal origins. Cost: O(n log n).
///
/// @returns a point of the fundamental domain with its corner at (0, 0), length units.
Vec2 find_box_origin(const PeriodicMesh& cells);

}  // namespace pcvt::plane
