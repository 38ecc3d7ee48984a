#pragma once

#include <string>
#include <vector>

#include "io/pictures/svg_legend.hpp"
#include "mesher/plane/geometry/polygon.hpp"

namespace pcvt {

/// One small picture of a tessellation.
///
/// Example usage:
///     CellPanel panel;
///     panel.caption = {"One cell"};
///     panel.outline = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
///     panel.cells = {{panel.outline, "#f0e4c8"}};
///     panel.sites = {{0.5, 0.5}};
///     output.stage("cells.svg", encode_cell_panels({"Cells", {}}, {panel}, {}));
struct CellPanel {
    /// Lines of text beneath the picture, the first one bold, each at most about 50 characters
    /// long.
    std::vector<std::string> caption;
    /// A polygon in length units; parts outside of the outline are drawn as well.
    struct Cell {
        plane::Polygon polygon;
        /// "#rrggbb"
        std::string colour;
    };
    std::vector<Cell> cells;
    /// The positions of the dots, length units.
    std::vector<plane::Vec2> sites;
    /// A line drawn over the cells; its bounding box determines the scale.
    plane::Polygon outline;
};

struct PanelLayout {
    int columns = 4;
    /// The longer side of each panel's outline, in pixels.
    double size = 220;
};

/// Encodes an SVG picture of the panels, row by row, with the legend's caption above and its
/// entries beneath. Coordinates are rounded to hundredths of a pixel.
std::string encode_cell_panels(const Legend& legend, const std::vector<CellPanel>& panels,
                               const PanelLayout& layout);

}  // namespace pcvt
