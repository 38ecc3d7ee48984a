#pragma once

#include "io/surfaces/surface_list.hpp"
#include "io/tiles/encoded_file.hpp"

namespace pcvt {

/// Encodes surfaces as binary glTF 2.0 in single precision: a node for each cell or each side of
/// the seam, or one node with a primitive a colour for more than kMaxCellNodes of them. Faces are
/// fans of triangles with the normal of their face. The node `tile` above them has
/// `extras.periodic`:
///
///     {"kind": "polyhedra" | "boundary", "lattice": [a, b, c], "sites": [[x, y, z], ...]}
///
/// Example usage:
///     const auto files = encode_surface_glb(surface_list(tile, SurfaceForm::kCells), "tile.glb");
///
/// @throws CoarsePrecision  single precision cannot hold a coordinate.
/// @throws LimitExceeded  the file would have more than 2 GiB.
std::vector<EncodedFile> encode_surface_glb(const SurfaceList& list, const std::string& path);

}  // namespace pcvt
