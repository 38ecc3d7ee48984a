#pragma once

#include <vector>

#include "mesher/plane/proof/glued_faces.hpp"
#include "mesher/plane/proof/site_images.hpp"

namespace pcvt::plane {

/// The cells of glued faces.
struct GluedImages {
    /// For each face the image of its site, in the basis of the lattice of the sites.
    std::vector<Offset> image;
    /// Whether the face may belong to another image.
    std::vector<bool> is_unclear;
};

struct FaceImageOptions {
    /// Whether the outline is that of a box, which cuts cells.
    bool is_box;
    /// The largest distance of corners beyond the bisector of two images of a site, length units.
    double reach;
    /// The walls at which cells may be cut, besides a box.
    Walls walls = Walls::kNone;
};

/// Finds the cell of each face, as prove_moved_cells() describes it.
///
/// Example usage:
///   const FaceImageOptions options{.is_box = false, .reach = 0};
///   const GluedImages found = find_face_images(tile, faces, images, options);
///   const Vec2 site = images.position(tile.face_site[f], found.image[f]);
///
/// @throws NotATile for laws (4) and (9) of prove_sites(), and where an image has no face.
GluedImages find_face_images(const Tile& tile, const GluedFaces& faces, const SiteImages& images,
                             const FaceImageOptions& options);

}  // namespace pcvt::plane
