#pragma once

#include "io/tiles/encoded_file.hpp"
#include "mesher/space/tile/tile_surface.hpp"

namespace pcvt {

/// Encodes the boundary of a tile as an OpenMesh file with the properties of OpenMeshSurface.
///
/// Example usage:
///     const auto files = encode_surface_om(tile_surface(mesh, sites), "tile.om");
///
/// @throws InvalidInput if the boundary is no manifold.
std::vector<EncodedFile> encode_surface_om(const space::TileSurface& surface,
                                           const std::string& path);

}  // namespace pcvt
