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

/// One entry at pixels (x, y): its mark, and its label on the base line y.
std::string legend_entry(double x, double y, const LegendEntry& entry);

/// A laid out legend: what to draw, and the size of the whole canvas with it.
struct PlacedLegend {
    std::string svg;
    double width;
    double height;
};

/// Puts the legend beneath the drawing, or beside one that is tall and narrow.
PlacedLegend place_legend(const Legend& legend, const SvgFrame& frame);

}  // namespace pcvt
