#pragma once

#include <vector>

#include "io/bytes/output.hpp"
#include "io/tile_formats.hpp"
#include "mesher/proof/validate.hpp"

namespace pcvt {

/// Proves a tile of ours in double precision, with what it stores of its seam.
/// @throws InternalError  it breaks a law: a fault of pcvt.
TileProof verify_generated_tile(const Tile& tile);

/// Proves that the disk gives the staged files back as they were encoded: what is read in `files`
/// from here on is what stands there.
/// @throws OutputError  it gives other bytes.
void require_on_disk(const OutputSet& outputs, const std::vector<EncodedFile>& files);

/// Proves the tile that `format` reads in `files`, with what they store of its seam. Where that is
/// number for number a tile that is proved already, nothing is left to prove.
/// @pre format.decode != nullptr.
/// @param original  the tile that was encoded, proved.
/// @param origin    the corner of its domain, for the advice in a message.
/// @throws InvalidInput   `original` is too fine for the format's single precision.
/// @throws InternalError  a law is broken all the same: a fault of pcvt.
void prove_files(const TileFormat& format, const std::vector<EncodedFile>& files,
                 const Tile& original, const Vec2& origin);

/// Proves the C-grid in an MPAS file of ours.
/// @throws InternalError  a law is broken: a fault of pcvt.
void prove_mpas_grid_file(const EncodedFile& file);

}  // namespace pcvt
