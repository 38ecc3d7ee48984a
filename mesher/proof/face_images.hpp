#pragma once

#include <vector>

#include "mesher/proof/glued_faces.hpp"
#include "mesher/proof/site_images.hpp"

namespace pcvt {

/// The cells of glued faces.
struct GluedImages {
    /// For each face the image of its site, in the basis of the lattice of the sites.
    std::vector<Offset> image;
    /// Whether it may be another one.
    std::vector<bool> is_unclear;
};

struct FaceImageOptions {
    /// Whether the outline is that of a box, which cuts cells.
    bool is_box;
    /// How far corners may lie beyond the bisector of two images of a site, length units.
    double reach;
};

/// Finds the cell of each face, as prove_moved_cells() describes it.
///
/// Example usage:
///   const GluedImages found = find_face_images(tile, faces, images, {.is_box = false, .reach =
///   0}); const Vec2 site = images.position(tile.face_site[f], found.image[f]);
///
/// @throws NotATile for laws (4) and (9) of prove_sites(), and where an image has no face.
GluedImages find_face_images(const Tile& tile, const GluedFaces& faces, const SiteImages& images,
                             const FaceImageOptions& options);

}  // namespace pcvt
