#pragma once

#include <string>

#include "mesher/space/mesh/tetrahedral_mesh.hpp"

namespace pcvt {

/// Fills the offsets of the points of tetrahedra that were read from a file: each is the rounded
/// difference from the first point of the same site, in period vectors.
///
/// Example usage:
///     TetrahedralMesh mesh = points_and_tetrahedra_of(file);
///     find_point_offsets("tile.msh", mesh);
///
/// @pre each point_site is from 0 to n_points() - 1.
/// @throws BadFile  naming a point that lies too many periods away.
void find_point_offsets(const std::string& name, space::TetrahedralMesh& mesh);

/// Returns for each point the first one with the same site.
std::vector<int> first_points(const space::TetrahedralMesh& mesh);

}  // namespace pcvt
