#pragma once

#include "mesher/cvt/size_newton.hpp"
#include "mesher/space/power/power_diagram.hpp"

namespace pcvt::space {

/// Finds the weights that give the power cells of fixed sites in space prescribed volumes.
///
/// Example usage:
///
///     VolumeNewton newton(moving, workers);
///     const SizeFigures figures = newton.solve(volumes, 1e-10);
///     measure_cells(newton.diagram().regular(), workers, cells);
using VolumeNewton = SizeNewton<PowerDiagram>;

}  // namespace pcvt::space

namespace pcvt {

extern template class SizeNewton<space::PowerDiagram>;

}  // namespace pcvt
