#pragma once

#include "io/bytes/encoded_file.hpp"
#include "io/forms/file_options.hpp"
#include "mesher/plane/tile/tile.hpp"

namespace pcvt {

/// Encodes a picture of a tile. Cells are filled by default_picture_colouring() or
/// options.colouring and have a dot at their site, unless their colours are classes of values.
/// Delaunay triangles are pale, with a mark on each site; by sides, sites whose valence is six have
/// a dot. The seam is thick, with one hue for each offset up to its sign; the fundamental domain is
/// dashed; a legend explains and counts the colours.
///
/// Line widths follow the size of the cells, so that pictures of 1 and of 100,000 cells look alike.
/// The domain is the parallelogram of the period vectors, or of the reduced period vectors if those
/// are much shorter.
///
/// Example usage:
///     for (const EncodedFile& file : encode_svg(tile, {}, "tile.svg")) {
///         output.stage(file.path, file.bytes);
///     }
std::vector<EncodedFile> encode_svg(const plane::Tile& tile, const FileOptions& options,
                                    const std::string& path);

}  // namespace pcvt
