#pragma once

#include "mesher/cells/finite_volume_mesh.hpp"
#include "mesher/plane/tile/tile.hpp"

namespace pcvt {

/// Extrudes `tile` to one layer of prisms; `thickness` 0: by one mean spacing sqrt(area / n_faces).
///
/// Example usage:
///   const FiniteVolumeMesh extruded = extruded_mesh(tile);
///   for (const FiniteVolumePatch& patch : extruded.patches) std::cout << patch.name << "\n";
///
/// Laws of extruded meshes, tested by number:
///   (1) The first half of the points lies at z = 0, and point v is vertex v of the tile. Point v +
///       V of the second half lies above it at z = thickness. Cell f is the prism over face f.
///   (2) Inner faces come first, with owner < neighbour, sorted by (owner, neighbour); their normal
///       points out of the owner. Boundary faces follow, patch by patch; their normal points out of
///       the mesh.
///   (3) Each patch of a seam matches its partner face by face, and point by point if one face is
///       traversed forwards and the other backwards from its first point.
///   (4) Each wall of the tile is one patch with its name, and so are the holes of one name. Its
///       faces are those above the edges on that wall.
///
/// The seam becomes one pair of patches per translation, "seam_I_J" before "seam_-I_-J", where (I,
/// J) > 0. The patches of the walls follow in the order of kWallSides, then those of the holes in
/// the order of Tile::holes, then the empty ones "back" (z = 0) and "front".
FiniteVolumeMesh extruded_mesh(const plane::Tile& tile, double thickness = 0);

}  // namespace pcvt
