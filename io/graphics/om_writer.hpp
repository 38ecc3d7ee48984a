#pragma once

#include <string>
#include <vector>

#include "io/tiles/encoded_file.hpp"
#include "mesher/tile/openmesh_tile.hpp"

namespace pcvt {

/// OpenMesh's own format, in doubles and with the connectivity as it is: mesh and identification
/// come back with the same handles. Little-endian on every machine.
/// @throws InternalError if a coordinate is not finite, or OpenMesh does not write.
std::vector<EncodedFile> encode_om(const OpenMeshTile& tile, const std::string& path);

}  // namespace pcvt
