#pragma once

#include "mesher/space/mesh/polyhedral_mesh.hpp"

namespace pcvt::space {

/// Prove laws (1), (2) and (5) of PolyhedralMesh: the order of the faces, the cells one by one, and
/// that they are connected.
///
/// Example usage:
///     prove_face_order(mesh);
///     prove_cells(mesh, 4e-16);
///
/// @throws NotATile
void prove_face_order(const PolyhedralMesh& mesh);
/// @param tolerance  of positions, length units.
/// @returns the sum of the volumes.
double prove_cells(const PolyhedralMesh& mesh, double tolerance);

}  // namespace pcvt::space
