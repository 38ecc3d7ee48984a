#pragma once

#include <string>
#include <vector>

#include "io/bytes/encoded_file.hpp"
#include "io/forms/file_options.hpp"
#include "io/forms/surface_mesh.hpp"
#include "mesher/plane/tile/tile.hpp"

namespace pcvt {

/// Returns the paths of NAME.obj and NAME.mtl, in the order of encode_obj_mesh(). Blanks in the
/// name of the .mtl become '_', because `mtllib` lists names with blanks between them.
std::vector<std::string> obj_mesh_paths(const std::string& path);

/// Encodes polygons as Wavefront OBJ: groups, one material for each colour, and texture coordinate
/// k of vertex k. Comments that begin with `# pcvt` hold kind and notes, with indices from 1; the
/// comments above explain them.
///
/// Example usage:
///     const auto files = encode_obj_mesh(surface_mesh(list, SeamForm::kLines), "tile.obj");
///
/// @throws InternalError if a coordinate is not finite.
std::vector<EncodedFile> encode_obj_mesh(const SurfaceMesh& mesh, const std::string& path);

/// Returns the paths of NAME.obj, NAME.mtl and NAME.seam.json, in the order of encode_obj().
std::vector<std::string> obj_paths(const std::string& path);

/// Encodes a tile by encode_obj_mesh(), with z = 0, by default one material for each number of
/// sides, and its seam twice, in the comments and in NAME.seam.json. The comments hold the
/// positions of the sites too, where the tile has them.
///
/// Faces are in the order of their materials, which is that of TileColours, and keep their order
/// within one; vertices keep theirs. Texture coordinates are lattice coordinates
/// (mesher/plane/tile/texture_coordinates.hpp). The sidecar counts vertices from 0.
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
