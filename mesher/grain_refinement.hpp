#pragma once

#include "mesher/grain_triangulation.hpp"

namespace pcvt {

/// Refinement aims at angles above this, degrees: a little more than is promised.
inline constexpr double kWantedAngle = 22;

/// Refines until edges are about `size` long and no angle is smaller than kWantedAngle, but for
/// triangles whose three edges are firm.
///
/// J. Ruppert's Delaunay refinement (J. Algorithms 18, 1995) on the torus: a cell edge is split
/// where a vertex lies in the circle over it, else a triangle that is too large or too thin gets a
/// vertex in its circumcentre, or nearer to its shortest edge where that is enough (A. Ungor's
/// off-centre). A split acts on both sides of an edge, so cells stay conforming. Largest
/// circumradius first.
/// @param size  length units.
/// @returns how many triangles were given up as they are.
int refine(GrainTriangulation& grains, double size);

}  // namespace pcvt
