#pragma once

#include "mesher/space/geometry/metric.hpp"
#include "mesher/space/mesh/polyhedral_mesh.hpp"

namespace pcvt::space {

/// Maps cells that were computed in the round space of a metric back to the space of the user.
///
/// Example usage:
///   const Metric metric(3, {0, 0, 1});
///   const PeriodicDelaunay round = periodic_delaunay(
///       Sites(metric.to_round(lattice), metric.to_round(points)));
///   const Sites sites = metric.from_round(round.sites, lattice);
///   const CellComplex cells = from_round(
///       cell_complex(round.sites, round.tetrahedra), metric, sites);
///   PolyhedralMesh mesh = polyhedral_mesh(sites, cells);
///   mesh.metric = metric;
///
/// Laws, tested by number:
///   (1) The volumes of the cells, their faces and their offsets do not change.
///   (2) No other image of a site is nearer to a point of a cell, in the metric.
///
/// @param sites  as Metric::from_round() maps the sites of the cells.
CellComplex from_round(CellComplex complex, const Metric& metric, const Sites& sites);

/// Maps a tile to the round space of its metric.
PolyhedralMesh to_round(PolyhedralMesh mesh);

}  // namespace pcvt::space
