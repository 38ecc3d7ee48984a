#pragma once

#include <string>

#include "mesher/plane/tile/openmesh_properties.hpp"

namespace pcvt {

/// Encodes an OpenMesh structure with its persistent properties as OpenMesh's own format. OpenMesh
/// prints nothing meanwhile.
///
/// Example usage:
///     const std::string bytes = encode_om_mesh(tile.mesh, "tile.om");
///
/// @param path  for messages.
/// @throws InternalError if OpenMesh fails.
std::string encode_om_mesh(const plane::CellMesh& mesh, const std::string& path);
std::string encode_om_mesh(const plane::TriangleMesh& mesh, const std::string& path);

}  // namespace pcvt
