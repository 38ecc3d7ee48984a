#pragma once

#include "io/bytes/encoded_file.hpp"
#include "io/gltf/gltf_container.hpp"
#include "io/gltf/gltf_surface.hpp"

namespace pcvt {

/// Encodes a surface as glTF 2.0 in single precision, in one file. The scene has a node `tile` with
/// the translation and extras.periodic; its children are the groups, and a node `outlines` of the
/// lines, lifted along z by 0.002 of the larger side of the bounding box of the points along x and
/// y. The buffer holds the points and their quantities, then the indices, of all faces, or of one
/// primitive after the other where faces share no points; then the lines, and the numbers of the
/// extras. Faces are fans of triangles round their first corner.
///
/// Example usage:
///     const auto files = encode_gltf_surface(gltf_surface(std::move(list)), "tile.glb",
///                                            GltfContainer::kBinary);
///
/// @throws CoarsePrecision  naming the path: single precision cannot hold a coordinate.
/// @throws LimitExceeded  naming the path: the file would have more than 2 GiB.
std::vector<EncodedFile> encode_gltf_surface(const GltfSurface& surface, const std::string& path,
                                             GltfContainer container);

}  // namespace pcvt
