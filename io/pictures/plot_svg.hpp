#pragma once

#include <string>
#include <vector>

#include "mesher/lattice/lattice.hpp"

namespace pcvt {

/// Colours of series that go well together, also for the colour-blind.
inline constexpr const char* kPlotBlue = "#255fb0";
inline constexpr const char* kPlotOrange = "#cb4b1e";
inline constexpr const char* kPlotGreen = "#0a8f63";
inline constexpr const char* kPlotGrey = "#6a7180";

struct PlotAxis {
    /// With the unit, where there is one.
    std::string label;
    bool logarithmic = false;
};

struct PlotSeries {
    enum class Mark { kLine, kDashes, kDots, kLineAndDots };
    Mark mark = Mark::kLine;
    /// Empty: not in the legend.
    std::string label;
    /// "#rrggbb"
    std::string colour;
    /// Finite, and above 0 along a logarithmic axis.
    std::vector<Vec2> points;
    /// Half the heights of the bars through the points; empty: no bars.
    std::vector<double> errors = {};
};

struct Plot {
    std::string title;
    PlotAxis x;
    PlotAxis y;
    std::vector<PlotSeries> series;
};

/// The values at which an axis from `low` to `high` is marked, rising, three at least where that is
/// possible: 1, 2 or 5 times a power of ten apart; along a logarithmic axis whole decades, or their
/// 1, 2, 5, or all digits, whichever are the first to be three.
std::vector<double> axis_ticks(double low, double high, bool logarithmic);

/// An SVG picture of the plots side by side, each with its title, legend, axes and grid.
/// @throws InternalError if a point cannot be drawn, or there is none.
std::string encode_plots(const std::string& title, const std::vector<Plot>& plots);

}  // namespace pcvt
