#pragma once

#include "mesher/cvt/size_newton.hpp"
#include "mesher/plane/power/power_diagram.hpp"

namespace pcvt::plane {

/// Finds the weights that give the power cells of fixed sites in the plane prescribed areas.
///
/// Example usage:
///
///     AreaNewton newton(delaunay, workers);
///     const SizeFigures figures = newton.solve(areas, 1e-10);
///     measure_cells(newton.diagram().regular(), newton.diagram().heights(), workers, cells);
using AreaNewton = SizeNewton<PowerDiagram>;

}  // namespace pcvt::plane

namespace pcvt {

extern template class SizeNewton<plane::PowerDiagram>;

}  // namespace pcvt
