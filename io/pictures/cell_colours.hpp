#pragma once

#include <string>
#include <vector>

#include "io/pictures/svg_legend.hpp"
#include "mesher/tile/tile.hpp"

namespace pcvt {

/// A colour for each face of a tile of cells or grains, and what the colours mean.
struct CellColours {
    std::vector<std::string> of_face;
    std::vector<LegendEntry> meaning;
};

/// By the number of sides of the cell that a face belongs to.
CellColours colours_by_sides(const Tile& tile);

/// By sqrt(area) / h of the cell that a face belongs to, h = sqrt(area of the tile / n): classes of
/// equal ratios, 2^(1/16) or a power of it, nine of them at most.
CellColours colours_by_size(const Tile& tile);

}  // namespace pcvt
