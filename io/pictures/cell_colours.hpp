#pragma once

#include <string>
#include <vector>

#include "io/pictures/svg_legend.hpp"
#include "mesher/tile/tile.hpp"

namespace pcvt {

/// A colour for each face of a tile of cells or grains, and the meaning of the colours.
struct CellColours {
    std::vector<std::string> of_face;
    std::vector<LegendEntry> meaning;
};

/// Returns colours by the number of sides of each face's cell.
CellColours colours_by_sides(const Tile& tile);

/// Returns colours by the size sqrt(area) / h of each face's cell, with h = sqrt(area of the tile /
/// n): at most nine classes of one ratio, the least of 2^(1/16), 2^(1/8), 2^(1/4), ... that
/// suffices.
CellColours colours_by_size(const Tile& tile);

}  // namespace pcvt
