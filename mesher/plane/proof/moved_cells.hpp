#pragma once

#include <vector>

#include "mesher/plane/proof/site_images.hpp"
#include "mesher/plane/proof/validate.hpp"

namespace pcvt::plane {

/// The image of its site to which each face of a tile belongs.
struct FaceImages {
    /// For each face, in the basis of the lattice of the sites.
    std::vector<Offset> of_face;
    /// Whether the file determines all of them.
    bool are_clear = true;
};

/// The largest distances by which the builder of a tile moves corners, length units.
struct CornerMoves {
    /// Edges shorter than this are removed.
    double removed;
    /// Corners of grains nearer to the box than this lie on it.
    double snap;
    /// The walls at which cells may be cut, if the tile includes its mirror images.
    Walls walls = Walls::kNone;
};

/// Proves laws (4) and (7) to (9) of prove_sites() for cells and grains whose corners were moved,
/// and finds the cell of each face.
///
/// Example usage:
///   const SiteImages images(tile, site_positions(tile));
///   const FaceImages cells = prove_moved_cells(tile, proof, images, {0.02 * h, 0.03 * h});
///
/// Two faces of one site that share an edge lie in one cell (in a box outline also across the seam)
/// unless the cell touches another image of itself inside of the tile: the faces of the site form
/// fewer parts than the tile has periods, or a part that goes round the torus. The image of a cell
/// is the one that is nearest to most of its area. Where cells touch, each face is on the side of
/// the bisector of two images on which its middle, or its corner that is farthest from the
/// bisector, lies. That is clear if this point is farther from the bisector than corners move;
/// where it is not and a law fails, the law is not required of the vertices of the face, and
/// are_clear is false.
///
/// @param tile  of a round metric.
/// @throws NotATile naming the site and the face or the vertex.
FaceImages prove_moved_cells(const Tile& tile, const TileProof& proof, const SiteImages& images,
                             const CornerMoves& moves);

}  // namespace pcvt::plane
