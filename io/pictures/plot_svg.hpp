#pragma once

#include <string>
#include <vector>

#include "mesher/plane/geometry/lattice.hpp"

namespace pcvt {

/// Colours of series that colour-blind readers can distinguish as well.
inline constexpr const char* kPlotBlue = "#3b78d0";
inline constexpr const char* kPlotOrange = "#cb4b1e";
inline constexpr const char* kPlotGreen = "#0a8f63";
inline constexpr const char* kPlotGrey = "#7a8291";

struct PlotAxis {
    /// The label with its unit, if it has one.
    std::string label;
    bool logarithmic = false;
};

struct PlotSeries {
    enum class Mark { kLine, kDashes, kDots, kLineAndDots };
    Mark mark = Mark::kLine;
    /// Empty: the series is not in the legend.
    std::string label;
    /// "#rrggbb"
    std::string colour;
    /// Finite coordinates, above 0 along a logarithmic axis.
    std::vector<plane::Vec2> points;
    /// Half the heights of the error bars at the points; empty: no bars.
    std::vector<double> errors = {};
};

/// One diagram with its series.
///
/// Example usage:
///     Plot plot{.title = "Energy", .x = {"iteration"}, .y = {"F", true}, .series = {}};
///     plot.series.push_back({PlotSeries::Mark::kLine, "run 1", kPlotBlue, {{0, 1}, {9, 0.5}}});
///     output.stage("energy.svg", encode_plots("Energy by iteration", {plot}));
struct Plot {
    std::string title;
    PlotAxis x;
    PlotAxis y;
    std::vector<PlotSeries> series;
};

/// Encodes an SVG picture of the plots side by side, each with its title, legend, axes and grid.
/// @throws InternalError if a point cannot be drawn, or there is none.
std::string encode_plots(const std::string& title, const std::vector<Plot>& plots);

/// Returns the points of all series as JSON, for pages that show values under the pointer:
/// [{"label": "periodic CVT", "points": [[px, py, x, y], ...]}, ...], px and py the pixels in the
/// picture of encode_plots(). Dashed series, which do not show data, are left out.
std::string plot_points(const std::vector<Plot>& plots);

}  // namespace pcvt
