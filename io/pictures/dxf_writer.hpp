#pragma once

#include "io/bytes/encoded_file.hpp"
#include "io/forms/file_options.hpp"
#include "mesher/plane/tile/tile.hpp"

namespace pcvt {

/// Encodes the edges of a tile as ASCII DXF R12: one LINE for each edge, those inside the tile in
/// the layer CUT and those of its boundary in SEAM. The lower left corner of the drawing is 0.
///
/// Coordinates are millimetres if options.cut_width is the width of the tile, else lengths of the
/// tile; R12 names no unit.
///
/// Example usage:
///     for (const EncodedFile& file : encode_dxf(tile, {.cut_width = 300}, "tile.dxf")) {
///         output.stage(file.path, file.bytes);
///     }
std::vector<EncodedFile> encode_dxf(const plane::Tile& tile, const FileOptions& options,
                                    const std::string& path);

}  // namespace pcvt
