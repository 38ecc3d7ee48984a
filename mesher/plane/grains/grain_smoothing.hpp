#pragma once

#include "mesher/plane/grains/grain_triangulation.hpp"

namespace pcvt::plane {

/// Moves the vertices inside the cells of triangles with an angle below `wanted`, degrees, as long
/// as a move increases the smallest angle around a vertex.
///
/// Example usage:
///   refine(grains, sizes);
///   widen_angles(grains, kWantedAngle);
void widen_angles(GrainTriangulation& grains, double wanted);

}  // namespace pcvt::plane
