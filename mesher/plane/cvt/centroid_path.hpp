#pragma once

#include "mesher/cvt/centroid_fit.hpp"
#include "mesher/plane/energy/energy.hpp"
#include "mesher/plane/power/power_diagram.hpp"

namespace pcvt::plane {

using CentroidPathObjective = CentroidObjective<EnergyPass, PowerDiagram>;

/// Minimises P along the path of the minima of P_c (centroid_objective.hpp), by Newton's steps in
/// sites and weights at once. The distance of the centroids falls in proportion to c. It ends at
/// the tolerance, or as stalled once the centroids no longer come nearer: then the sites are those
/// of the last c, still apart.
///
/// Example usage:
///
///     CentroidPathObjective objective(moving, areas, workers, callback, measure, pairs);
///     const RunStatistics run = follow_centroid_path(objective, {.tolerance = 1e-6});
///     const CentroidFigures figures = objective.finish(1e-10);
///
/// 300 cells of random sites are found after some 30 steps, relaxed ones after 5.
RunStatistics follow_centroid_path(CentroidPathObjective& objective, const RunOptions& run);

}  // namespace pcvt::plane
