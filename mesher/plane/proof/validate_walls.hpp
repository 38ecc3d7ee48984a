#pragma once

#include "mesher/plane/proof/glued_faces.hpp"
#include "mesher/plane/proof/validate.hpp"

namespace pcvt::plane {

/// The results of laws (1) and (2) of prove_tile().
struct Gluing {
    TileProof proof{};
    GluedFaces faces;
};

/// Four ulps of the largest coordinate, length units. In double precision, the coordinates of the
/// domain from which elongated cells come count as well.
double position_tolerance(const Tile& tile, Precision precision);

/// Proves law (6).
/// @throws NotATile naming the vertex and the wall.
void require_between_walls(const Tile& tile, Precision precision);

/// The tile with its vertices and sites on walls exactly there, from where single precision moves
/// them.
Tile with_exact_walls(Tile tile, double tolerance);

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
/// faces, but those of a fan of triangles in the opposite order, so that they stay a fan. A site on
/// a wall is its own image; the images of the other sites have new ids, in the same order.
Tile mirrored_tile(Tile tile);

/// The part of a gluing of mirrored_tile(tile) that belongs to the tile. Edges on walls are their
/// own opposites, and their `across` is not 0.
///
/// Example usage:
///   const Gluing part = part_of_tile(channel, glued(mirrored_tile(channel), precision));
///   const std::vector<WallEdge>& walls = part.proof.wall_edges;
Gluing part_of_tile(const Tile& tile, const Gluing& torus);

}  // namespace pcvt::plane
