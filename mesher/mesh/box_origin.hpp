#pragma once

#include "mesher/mesh/periodic_mesh.hpp"

namespace pcvt {

/// An origin for cut_along_box (box_outline.hpp) that leaves no edge shorter than needs be.
///
/// On the torus the origin of the cut is free. The shortest edge that the cut makes is looked at
/// for a few hundred positions of each family of lines, the best of them are paired, and the best
/// pair is moved in ever smaller steps. What is found is good, not proved to be the best. The same
/// cells give the same origin. Cost: O(n log n).
///
/// @returns a point of the fundamental domain at (0, 0), length units.
Vec2 find_box_origin(const PeriodicMesh& cells);

}  // namespace pcvt
