#pragma once

#include "mesher/mesh/periodic_mesh.hpp"

namespace pcvt {

/// The `whole` outline: for each face the offset at which it stands in the tile.
///
/// The union of the placed faces is a disc and no face is cut. Faces stand where their centroid
/// lies in the reduced fundamental domain with its corner at `origin`, unless that would pinch the
/// disc or tear it apart; such faces go to the nearest place where it stays whole.
std::vector<Offset> whole_outline(const PeriodicMesh& mesh, const Vec2& origin);

}  // namespace pcvt
