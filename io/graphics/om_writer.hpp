#pragma once

#include <string>
#include <vector>

#include "io/bytes/encoded_file.hpp"
#include "mesher/plane/tile/tile.hpp"
#include "mesher/space/tile/tile_surface.hpp"

namespace pcvt {

/// Encodes a tile in OpenMesh's own format, in double precision and with its connectivity, so that
/// mesh and identification read back with the same handles. Little-endian on every machine.
///
/// Example usage:
///     for (const EncodedFile& file : encode_om(tile, "tile.om")) {
///         output.stage(file.path, file.bytes);
///     }
///
/// @throws InvalidInput  as openmesh_tile().
/// @throws InternalError if a coordinate is not finite, or OpenMesh fails to write.
std::vector<EncodedFile> encode_om(const plane::Tile& tile, const std::string& path);

/// Encodes the boundary of a tile in space with the properties of OpenMeshSurface
/// (mesher/space/tile/openmesh_surface.hpp).
/// @throws InvalidInput if the boundary is not a manifold.
std::vector<EncodedFile> encode_om_boundary(const space::TileSurface& surface,
                                            const std::string& path);

}  // namespace pcvt
