#pragma once

#include "mesher/plane/proof/validate.hpp"

namespace pcvt::plane {

/// Proves a tile that pcvt has generated, in double precision, with its stored pairs and its
/// site ids.
/// @throws InternalError  the tile breaks a law: a fault of pcvt.
TileProof verify_generated_tile(const Tile& tile);

/// Whether single precision resolves the smallest feature of a proved tile, so that the tile keeps
/// its laws there.
/// @param from  the point to which stored positions are relative.
bool fits_single_precision(const Tile& tile, const Vec2& from);

}  // namespace pcvt::plane
