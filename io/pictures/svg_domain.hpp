#pragma once

#include <string>
#include <vector>

#include "mesher/plane/tile/tile.hpp"

namespace pcvt {

/// The fundamental domain that is drawn over a tile.
struct SvgDomain {
    /// Four points, in order around the domain.
    std::vector<plane::Vec2> corners;
    std::string label;
};

/// Returns the parallelogram along which cells are cut, for a tile with the box outline. For a
/// whole outline, returns the parallelogram at the lattice point where it covers the tile best, in
/// the reduced basis if the typed one is much longer.
SvgDomain drawn_domain(const plane::Tile& tile);

}  // namespace pcvt
