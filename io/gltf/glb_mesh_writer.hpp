#pragma once

#include "io/forms/surface_mesh.hpp"
#include "io/tiles/encoded_file.hpp"

namespace pcvt {

/// Encodes surfaces in space as binary glTF 2.0 in single precision: a node for each group, or one
/// node with a primitive a colour for more than kMaxCellNodes of them. Faces are fans of triangles
/// with the normal of their face. The node `tile` above them has `extras.periodic`:
///
///     {"kind": "polyhedra" | "boundary", "lattice": [a, b, c], "sites": [[x, y, z], ...]}
///
/// Example usage:
///     const auto files = encode_glb_mesh(surface_mesh(list, SeamForm::kNone), "tile.glb");
///
/// @throws CoarsePrecision  single precision cannot hold a coordinate.
/// @throws LimitExceeded  the file would have more than 2 GiB.
std::vector<EncodedFile> encode_glb_mesh(const SurfaceMesh& mesh, const std::string& path);

}  // namespace pcvt
