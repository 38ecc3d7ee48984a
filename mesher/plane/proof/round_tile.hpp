#pragma once

#include "mesher/plane/tile/tile.hpp"

namespace pcvt::plane {

/// Returns the tile in the space in which its metric is the Euclidean one: points, positions of
/// sites and lattice are mapped, the seam and the faces stay. Weights and areas are the same there.
///
/// Example usage:
///   const Tile round = round_tile(tile);
///   // The cells of `round` are the ordinary cells of its sites.
Tile round_tile(Tile tile);

}  // namespace pcvt::plane
