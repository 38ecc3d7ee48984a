#pragma once

#include <vector>

#include "mesher/plane/geometry/polygon.hpp"
#include "mesher/plane/proof/glued_faces.hpp"

namespace pcvt::plane {

/// Returns the polygons of the holes, counter-clockwise: each is a loop of edges of holes, in the
/// frame of one of its faces.
/// @throws NotATile if a loop goes round the torus, has two names, or is not a simple polygon.
std::vector<Polygon> hole_polygons(const Tile& tile, const GluedFaces& faces, double tolerance);

}  // namespace pcvt::plane
