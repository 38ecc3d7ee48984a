#pragma once

#include "mesher/grains/grain_triangulation.hpp"

namespace pcvt {

/// Moves vertices inside of cells where that widens the smallest angle round them, first at the
/// triangles with an angle below `wanted`, degrees, until no move helps.
void widen_angles(GrainTriangulation& grains, double wanted);

}  // namespace pcvt
