#pragma once

#include <optional>

#include "mesher/space/mesh/polyhedral_mesh.hpp"
#include "mesher/space/proof/tetrahedral_proof.hpp"

namespace pcvt::space {

/// Decides whether a tile is the box of the period vectors at some corner: all boundary faces lie
/// in the six sides of one parallelepiped.
///
/// Example usage:
///     const std::optional<Vec3> corner = box_corner(mesh, proof.tolerance);
///
/// @pre prove_polyhedra(), or prove_tetrahedra() with this proof, has proved the mesh.
/// @param tolerance  of positions, length units.
/// @returns the corner, length units; nothing if the tile is no box.
std::optional<Vec3> box_corner(const PolyhedralMesh& mesh, double tolerance);
std::optional<Vec3> box_corner(const TetrahedralMesh& mesh, const TetrahedralProof& proof);

}  // namespace pcvt::space
