#pragma once

#include <array>

#include "io/forms/surface_list.hpp"
#include "io/forms/surface_mesh.hpp"
#include "io/tiles/encoded_file.hpp"

namespace pcvt {

/// Triangles in single precision, three points each.
struct GlbPart {
    /// Of the node.
    std::string name;
    std::vector<std::array<float, 3>> corners;
    /// The vertex of each corner, and a normal for each vertex.
    std::vector<int> vertices = {};
    std::vector<std::array<float, 3>> normals = {};
};

/// The surfaces of a file of encode_glb_mesh().
struct GlbSurfaces {
    SurfaceForm form = SurfaceForm::kCells;
    space::Lattice lattice = space::Lattice::box(1, 1, 1);
    space::Points sites = space::Points(3, 0);
    /// One for each primitive.
    std::vector<GlbPart> parts = {};
};

/// Whether a file says that it is a GLB of encode_glb_mesh().
bool holds_glb_surfaces(const EncodedFile& file);

/// Reads the triangles, the lattice and the sites.
/// @throws BadFile naming the file.
GlbSurfaces decode_glb_surfaces(const EncodedFile& glb);

/// Requires that the triangles are those of the faces of a mesh, and the nodes its groups.
/// @throws NotATile if another triangle or name is found.
void require_same_surfaces(const GlbSurfaces& glb, const SurfaceMesh& mesh);

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
/// Example usage:
///     std::cout << prove_glb_surfaces(decode_glb_surfaces(file)).volume;
///
/// @throws NotATile with the part that breaks a law.
GlbProof prove_glb_surfaces(const GlbSurfaces& glb);

}  // namespace pcvt
