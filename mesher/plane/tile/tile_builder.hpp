#pragma once

#include <vector>

#include "mesher/plane/mesh/periodic_mesh.hpp"
#include "mesher/plane/mesh/walled_mesh.hpp"
#include "mesher/plane/tile/tile.hpp"

namespace pcvt::plane {

/// Makes the tile of the faces of `periodic`, face f in the image placement[f].
///
/// Example usage:
///   const PeriodicMesh cells = cell_mesh(delaunay);
///   const Tile tile = make_tile(cells, whole_outline(cells, {0, 0}));
///
/// Vertices are numbered in the order in which the corners of the faces meet them. The edge pairs
/// are in the order of the corners whose edges have positive offsets. Laws, tested by number:
///   (1) The partner of a boundary edge runs the other way: its ends are translates of the ends.
///   (2) Positions are representative + translation, so the two sides of the seam agree to the
///       rounding of one addition.
///   (3) V - E + F = 1, and 0 after gluing.
///   (4) The face areas sum to lattice.area().
/// @pre the placed faces form a disc, as whole_outline() and cut_along_box() promise; prove_tile()
///      refuses other tiles.
/// @throws InternalError if `placement` does not have one entry for each face.
Tile make_tile(const PeriodicMesh& periodic, const std::vector<Offset>& placement);

/// The same for a mesh between walls (mesh_between_walls()), whose walls the tile states.
Tile make_walled_tile(const PeriodicMesh& between, const std::vector<Offset>& placement,
                      const WalledDomain& domain);

}  // namespace pcvt::plane
