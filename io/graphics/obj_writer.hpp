#pragma once

#include <string>
#include <vector>

#include "io/tiles/encoded_file.hpp"
#include "io/tiles/file_options.hpp"
#include "mesher/plane/tile/tile.hpp"

namespace pcvt {

/// Returns the paths of NAME.obj, NAME.mtl and NAME.seam.json, in the order of encode_obj(). Blanks
/// in the name of the .mtl become '_', because `mtllib` lists names with blanks between them.
std::vector<std::string> obj_paths(const std::string& path);

/// Encodes a tile as Wavefront OBJ: polygons with z = 0, one material for each colour, by default
/// for each number of sides, and the seam twice, in comments that begin with `# pcvt` and in
/// NAME.seam.json. The comments hold the positions of the sites too, where the tile knows them.
///
/// Faces are grouped by material, in the order of TileColours, and keep their order within a group;
/// vertices keep theirs. Vertex k has the texture coordinate k, its lattice coordinates
/// (mesher/plane/tile/texture_coordinates.hpp). The comments count vertices from 1, as the faces
/// do; the sidecar counts from 0.
///
/// Example usage:
///     for (const EncodedFile& file : encode_obj(tile, {}, "tile.obj")) {
///         output.stage(file.path, file.bytes);
///     }
///
/// @throws InternalError if a coordinate is not finite.
std::vector<EncodedFile> encode_obj(const plane::Tile& tile, const FileOptions& options,
                                    const std::string& path);

}  // namespace pcvt
