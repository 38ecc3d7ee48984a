#pragma once

#include "mesher/space/mesh/polyhedral_mesh.hpp"
#include "mesher/space/mesh/tetrahedral_mesh.hpp"

namespace pcvt::space {

/// Puts the points of a tile that lie on the sides of the box exactly there, and the corners of
/// the box at its corners: computed points lie within some roundings of them. Where a side is
/// normal to a coordinate axis, its points have one coordinate to the last bit.
///
/// Law, tested by number:
///   (1) Points of one orbit remain the first one plus a translation.
///
/// @param origin  the corner of the box, length units.
/// @param mesh    a tile of pieces that cells_in_box() made.
void put_on_sides(const Vec3& origin, PolyhedralMesh& mesh);
void put_on_sides(const Vec3& origin, TetrahedralMesh& mesh);

}  // namespace pcvt::space
