#pragma once

#include <vector>

#include "io/output.hpp"
#include "io/tile_formats.hpp"
#include "mesher/validate.hpp"

namespace pcvt {

/// Proves a tile of ours in double precision, with what it stores of its seam.
/// @throws InternalError  it breaks a law: a fault of pcvt.
TileProof prove_own_tile(const AnyTile& tile);

/// The files as the disk gives them back.
/// @throws OutputError  other bytes than those of `encoded`.
std::vector<EncodedFile> read_back(const OutputSet& outputs,
                                   const std::vector<EncodedFile>& encoded);

/// Proves the tile that `format` reads in `files`, with what they store of its seam.
/// @pre format.decode != nullptr.
/// @param original  the tile that was encoded.
/// @param origin    the corner of its domain, for the advice in a message.
/// @throws InvalidInput   `original` is too fine for the format's single precision.
/// @throws InternalError  a law is broken all the same: a fault of pcvt.
void prove_files(const TileFormat& format, const std::vector<EncodedFile>& files,
                 const AnyTile& original, const Vec2& origin);

/// Proves the C-grid in an MPAS file of ours.
/// @throws InternalError  a law is broken: a fault of pcvt.
void prove_c_grid_file(const EncodedFile& file);

}  // namespace pcvt
