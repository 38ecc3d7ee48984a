#pragma once

#include "io/pictures/cell_panels.hpp"
#include "mesher/cvt/clipped_cvt.hpp"
#include "mesher/cvt/cvt.hpp"

namespace pcvt {

/// The tessellation inside its domain: cells that cross the border come back at the other side. A
/// cell has the colour of its number of sides; hexagons that the border cuts are a shade darker.
CellPanel periodic_panel(const CvtResult& result);

/// The clipped cells; those at the border are green, the others have the colour of their sides.
CellPanel clipped_panel(const Lattice& lattice, const Points& sites);

/// The meaning of the colours that occur in the panels.
std::vector<LegendEntry> panel_legend(const std::vector<CellPanel>& panels);

}  // namespace pcvt
