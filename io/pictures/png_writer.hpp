#pragma once

#include "io/bytes/encoded_file.hpp"
#include "io/forms/file_options.hpp"
#include "io/pictures/periodic_canvas.hpp"
#include "mesher/plane/tile/tile.hpp"

namespace pcvt {

/// Larger images are refused.
inline constexpr int kMostImagePixels = 1 << 26;

/// Returns the height of an image of one period that is `width` pixels wide: its pixels are as
/// high as wide along the two period vectors.
/// @throws InvalidInput if the image has more than kMostImagePixels.
int image_height(const plane::Lattice& lattice, int width);

/// Draws one period of a tile: lattice coordinate u from 0 to 1 runs from left to right, v from 0
/// to 1 from bottom to top, wherever the tile lies. So copies of the image join without a seam, and
/// the image is the texture that fits the texture coordinates of OBJ and glTF. Rectangular periods
/// show the plane as it is; oblique ones show their parallelogram sheared into a rectangle.
///
/// Colours and edges are those of encode_svg(), without seam, domain and legend; a box outline
/// leaves no cut.
RgbImage draw_period(const plane::Tile& tile, const FileOptions& options, int width);

/// Encodes an image as PNG.
std::string encode_png(const RgbImage& image);

/// Encodes the image of one period as PNG.
///
/// Example usage:
///     for (const EncodedFile& file : encode_tile_png(tile, {.pixels = 512}, "tile.png")) {
///         output.stage(file.path, file.bytes);
///     }
std::vector<EncodedFile> encode_tile_png(const plane::Tile& tile, const FileOptions& options,
                                         const std::string& path);

}  // namespace pcvt
