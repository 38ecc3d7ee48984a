#pragma once

#include "mesher/tile/tile.hpp"

namespace pcvt {

/// Returns a tile between walls together with its mirror images: a tile of the torus whose lattice
/// is mirrored_lattice(). It has no walls, no pairs and no copies of vertices.
///
/// Example usage:
///   const Tile torus = mirrored_tile(channel);  // of twice the height
///   assert(torus.faces[f] == channel.faces[f]);
///
/// The vertices and faces of the given tile, other than its copies, keep their numbers and come
/// first. Images are mirrored at x = 0 and at y = 0; vertices on these lines are their own images.
/// The image of a face begins at the image of its first corner; images are in the order of the
/// faces, but those of a fan of triangles in the opposite order, so that they stay a fan. A site on a wall is its own image; the images of the
/// other sites have new ids, in the same order.
Tile mirrored_tile(Tile tile);

}  // namespace pcvt
