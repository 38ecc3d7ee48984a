#pragma once

#include "mesher/plane/geometry/metric.hpp"
#include "mesher/plane/mesh/periodic_mesh.hpp"

namespace pcvt::plane {

/// A metric, and the lattice that it maps to that of the round space.
struct Elongation {
    Metric metric;
    Lattice lattice;
};

/// Maps a mesh that was computed in the round space of a metric back to the plane.
///
/// Example usage:
///   const Metric metric(3, 30);
///   const PeriodicDelaunay round(Sites(metric.to_round(lattice), metric.to_round(points)));
///   const PeriodicMesh cells = from_round(cell_mesh(round), metric, lattice);
///
/// Laws, tested by number:
///   (1) Topology, offsets and areas are unchanged.
///   (2) No other image of a site is nearer to a point of a cell, in the metric.
///
/// @param lattice  the lattice that the metric maps to mesh.lattice; the result has it.
PeriodicMesh from_round(PeriodicMesh mesh, const Metric& metric, const Lattice& lattice);

}  // namespace pcvt::plane
