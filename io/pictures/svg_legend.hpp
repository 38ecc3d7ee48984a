#pragma once

#include <string>
#include <vector>

#include "io/pictures/svg_canvas.hpp"

namespace pcvt {

struct LegendEntry {
    enum class Mark { kPatch, kDisc, kStroke, kDashes };
    Mark mark;
    /// "#rrggbb"
    std::string colour;
    std::string label;
};

/// A picture's caption and the meaning of its colours.
struct Legend {
    std::string caption;
    std::vector<LegendEntry> entries;
};

/// Returns one entry at pixels (x, y): its mark, and its label on the base line y.
std::string legend_entry(double x, double y, const LegendEntry& entry);

/// A legend with its layout: its SVG text, and the size of the canvas that includes it.
struct PlacedLegend {
    std::string svg;
    double width;
    double height;
};

/// Places the legend beneath the drawing, or beside a drawing that is tall and narrow.
PlacedLegend place_legend(const Legend& legend, const SvgFrame& frame);

}  // namespace pcvt
