#pragma once

#include <string>
#include <vector>

#include "io/pictures/svg_legend.hpp"
#include "mesher/lattice/polygon.hpp"

namespace pcvt {

/// One small picture of a tessellation.
struct CellPanel {
    /// Lines of text beneath it, the first one bold; none longer than about 50 characters.
    std::vector<std::string> caption;
    /// Length units; what lies outside of the outline is not cut off.
    struct Cell {
        Polygon polygon;
        /// "#rrggbb"
        std::string colour;
    };
    std::vector<Cell> cells;
    /// Drawn as dots.
    std::vector<Vec2> sites;
    /// Drawn over the cells.
    Polygon outline;
};

struct PanelLayout {
    int columns = 4;
    /// Pixels of the longer side of each panel's outline.
    double size = 220;
};

/// An SVG picture of the panels, row by row, with the legend's caption above and its entries
/// beneath. Coordinates are rounded to hundredths of a pixel.
std::string encode_cell_panels(const Legend& legend, const std::vector<CellPanel>& panels,
                               const PanelLayout& layout);

}  // namespace pcvt
