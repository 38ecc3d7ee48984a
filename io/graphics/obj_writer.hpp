#pragma once

#include <string>
#include <vector>

#include "io/tiles/encoded_file.hpp"
#include "mesher/tile/tile.hpp"

namespace pcvt {

/// NAME.obj, NAME.mtl and NAME.seam.json.
std::vector<std::string> obj_paths(const std::string& path);

/// Wavefront OBJ: the faces as they are, z = 0, materials by the number of sides, the seam in
/// comments that begin with `# pcvt` and once more in NAME.seam.json.
///
/// Faces are grouped by material, fewest sides first, and keep their order within a group; vertices
/// keep theirs. Comments count vertices from 1 as the faces do, the sidecar counts from 0.
/// @throws InternalError if a coordinate is not finite.
std::vector<EncodedFile> encode_obj(const Tile& tile, const std::string& path);

}  // namespace pcvt
