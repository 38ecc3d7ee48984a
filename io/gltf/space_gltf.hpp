#pragma once

#include "io/bytes/encoded_file.hpp"
#include "io/forms/surface_list.hpp"
#include "io/gltf/gltf_surface.hpp"

namespace pcvt {

/// Returns surfaces in space as glTF shows them: a node for each group of surface_mesh(), or one
/// node, `cells` or `boundary`, for more than kMaxCellNodes of them. extras.periodic is
///
///     {"kind": "polyhedra" | "boundary", "lattice": [a, b, c], "sites": [[x, y, z], ...],
///      "weights": [w, ...], "colouring": "size", "phases": ["name", ...], "sitePhases": [k, ...],
///      "orientations": [[phi1, Phi, phi2], ...]}
///
/// where weights of power cells, colours other than those of the numbers of faces, and materials
/// are stated where there are some.
///
/// Example usage:
///     const GltfSurface surface = gltf_surface(surface_list(mesh, sites, SurfaceForm::kCells));
GltfSurface gltf_surface(SurfaceList list);

/// Encodes surfaces in space as binary glTF, as encode_gltf_surface().
std::vector<EncodedFile> encode_glb_surfaces(SurfaceList list, const std::string& path);

/// The surfaces of such a file. Their faces are the fans of triangles that the file holds, their
/// points its vertices, in single precision.
struct GlbSurfaces {
    /// The cell of a face is the number of its primitive; faces of a boundary have the offset that
    /// the name of their node states, and no partners.
    SurfaceList list = {};
    /// One for each primitive, with the name of its node.
    std::vector<FaceGroup> groups = {};
    /// One a point.
    std::vector<Point3> normals = {};

    /// The face behind the last one of a group.
    int group_end(std::size_t group) const {
        return group + 1 < groups.size() ? groups[group + 1].first_face : list.surface.n_faces();
    }
};

/// Whether a file says that it is a GLB of encode_glb_surfaces().
bool holds_glb_surfaces(const EncodedFile& file);

/// Reads the triangles, the lattice and the sites.
/// @throws BadFile naming the file.
GlbSurfaces decode_glb_surfaces(const EncodedFile& glb);

}  // namespace pcvt
