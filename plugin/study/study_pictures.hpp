#pragma once

#include "io/pictures/cell_panels.hpp"
#include "io/pictures/plot_svg.hpp"
#include "mesher/plane/cvt/clipped_cvt.hpp"
#include "mesher/plane/cvt/cvt.hpp"
#include "plugin/study/study.hpp"

namespace pcvt {

/// The tessellation inside its domain; cells that cross the border reappear on the opposite side.
/// The colour of a cell shows its number of sides; hexagons that the border cuts are a shade
/// darker.
CellPanel periodic_panel(const plane::CvtResult& result);

/// The same with a colour for the cells of each orbit; colours repeat.
/// @param orbit  of each site.
CellPanel orbit_panel(const plane::CvtResult& result, const std::vector<int>& orbit);

/// The clipped cells. Cells at the border are green; the colour of others shows their number of
/// sides.
CellPanel clipped_panel(const plane::Lattice& lattice, const plane::Points& sites);

/// Legend entries for the colours that occur in the panels.
std::vector<LegendEntry> panel_legend(const std::vector<CellPanel>& panels);

/// A picture of plots with their values.
StudyPicture plot_picture(const std::string& title, const std::vector<Plot>& plots);

}  // namespace pcvt
