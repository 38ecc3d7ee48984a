#pragma once

#include "io/gltf/space_gltf.hpp"

namespace pcvt {

/// Requires that the triangles are, in single precision, the fans of the faces of a surface, and
/// the nodes its groups.
/// @throws NotATile if another triangle or name is found.
void require_same_surfaces(const GlbSurfaces& glb, const GltfSurface& surface);

/// Whether single precision resolves the smallest feature of the surfaces of cells, so that the
/// proofs hold there.
bool fits_single_precision(const SurfaceMesh& mesh);

/// Figures that the proof of the triangles finds.
struct GlbProof {
    int n_parts = 0;
    int n_triangles = 0;
    double volume = 0;
    /// The largest possible error of the volume by single precision.
    double tolerance = 0;
};

/// Proves that the triangles of each cell, or those of the boundary, close: each directed edge
/// occurs as often as its reverse. Each cell has a positive volume, and all volumes sum to that of
/// the domain within the rounding of single precision.
///
/// For a file that pcvt wrote with a node for each part, it proves the other fields too: JSON,
/// indices and normals are those that encode_glb_surfaces() gives for the faces of the file; the
/// site of each cell, mirrored in any face of that cell, is an image of a site; of power cells,
/// each face lies in the plane that the sites and the weights on both sides give; each side of a
/// seam meets the other one by its translation. All of this holds within the rounding of single
/// precision. Files of other programs, and the single node of many parts, state less.
///
/// Example usage:
///     std::cout << prove_glb_surfaces(file, decode_glb_surfaces(file)).volume;
///
/// @throws NotATile with the part that breaks a law.
/// @throws BadFile  naming the file: a field is another one.
GlbProof prove_glb_surfaces(const EncodedFile& file, const GlbSurfaces& glb);

}  // namespace pcvt
