#pragma once

#include <optional>
#include <vector>

#include "io/tiles/encoded_file.hpp"
#include "io/tiles/tile_file.hpp"

namespace pcvt {

/// Reads the `.om` files of encode_om byte by byte, without OpenMesh, which trusts what it reads:
/// indices are in range, partners mutual, chunks as long as they say.
///
/// Faces, vertices and seam come back as flatten() gives them.
/// @param lattice  has no effect: a file of ours always names its lattice.
/// @throws BadFile naming what is wrong, also for an `.om` file without the identification.
TileFile decode_om(const std::vector<EncodedFile>& files, const std::optional<Lattice>& lattice);

}  // namespace pcvt
