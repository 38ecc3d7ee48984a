#pragma once

#include "io/bytes/encoded_file.hpp"
#include "mesher/plane/tile/tile.hpp"

namespace pcvt {

/// Encodes the edges of a tile as an SVG for cutters: each edge once, no fill, thin lines, sizes in
/// millimetres. The groups CUT (black) and SEAM (red) hold the edges inside the tile and those of
/// its boundary.
///
/// Example usage:
///     for (const EncodedFile& file : encode_svg_cut(tile, 300, "tile.svg")) {
///         output.stage(file.path, file.bytes);
///     }
/// @param width  of the tile in millimetres, above 0.
std::vector<EncodedFile> encode_svg_cut(const plane::Tile& tile, double width,
                                        const std::string& path);

}  // namespace pcvt
