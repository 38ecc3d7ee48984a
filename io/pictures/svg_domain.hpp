#pragma once

#include <string>
#include <vector>

#include "mesher/tile/tile.hpp"

namespace pcvt {

/// A fundamental domain as it is drawn over a tile.
struct SvgDomain {
    /// Four, in order.
    std::vector<Vec2> corners;
    std::string label;
};

/// Where cells are cut along the parallelogram: that itself. Else the parallelogram at the lattice
/// point where it covers the tile best, of the reduced basis if the typed one is much longer.
SvgDomain drawn_domain(const Tile& tile);

}  // namespace pcvt
