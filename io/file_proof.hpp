#pragma once

#include <vector>

#include "io/bytes/output.hpp"
#include "io/tile_formats.hpp"

namespace pcvt {

/// Proves that the staged files read back from the disk as they were encoded, so that a proof of
/// `files` is valid for the disk.
///
/// Example usage:
///   for (const EncodedFile& file : files) outputs.stage(file.path, file.bytes);
///   require_on_disk(outputs, files);
///   prove_tile_files(format, files, tile, {0, 0});
///
/// @throws OutputError  the disk returns other bytes.
void require_on_disk(const OutputSet& outputs, const std::vector<EncodedFile>& files);

/// Proves the tile that `format` reads in `files`, with the stored pairs. Skips the proof if every
/// number is that of `original`.
/// @pre decode_tile() takes the format.
/// @param original  the encoded tile, proved.
/// @param origin    the corner of its domain, for the advice in a message.
/// @throws InvalidInput   `original` is too fine for the format's single precision.
/// @throws InternalError  a law is violated: a fault of pcvt.
void prove_tile_files(const TileFormat& format, const std::vector<EncodedFile>& files,
                      const Tile& original, const Vec2& origin);

/// Proves the staggered grid that `format` reads in `files`.
/// @pre format.reads_grid().
/// @throws InternalError  a law is violated: a fault of pcvt.
void prove_grid_files(const TileFormat& format, const std::vector<EncodedFile>& files);

}  // namespace pcvt
