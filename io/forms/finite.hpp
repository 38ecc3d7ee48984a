#pragma once

#include "mesher/plane/tile/tile.hpp"

namespace pcvt {

/// Requires finite coordinates. Call it before any writer: no format here has a word for NaN or
/// infinity.
/// @throws InternalError naming the first vertex whose coordinates are not finite.
void require_finite(const plane::Tile& tile);

}  // namespace pcvt
