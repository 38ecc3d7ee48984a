#pragma once

#include "mesher/space/mesh/polyhedral_mesh.hpp"

namespace pcvt::space {

/// Returns whether the boundary of a tile is a manifold: each edge of it belongs to two boundary
/// faces, and the boundary faces at each point are one fan. Where corners of more than four cells
/// coincide (lattices), tiles may touch themselves along an edge or at a point.
///
/// Example usage:
///     if (!boundary_is_manifold(mesh)) std::cout << "the boundary touches itself\n";
bool boundary_is_manifold(const PolyhedralMesh& mesh);

}  // namespace pcvt::space
