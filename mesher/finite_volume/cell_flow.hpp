#pragma once

#include <vector>

#include "mesher/finite_volume/decaying_flow.hpp"
#include "mesher/finite_volume/extruded_mesh.hpp"
#include "mesher/plane/tile/tile.hpp"

namespace pcvt {

/// A DecayingFlow on the cells of an extruded tile: the initial state of a finite-volume solver.
///
/// The flow on cells falls to 1/e in time only if the cells resolve its waves, and a solver
/// without walls conserves the mean velocity. So the mean is subtracted, and cells that are too
/// large for the flow start at rest. Walls take up momentum; between walls the mean velocity stays.
///
/// Laws, tested by number:
///   (1) The area-weighted means of the tracer and, without walls, of the velocity are 0.
///   (2) During a time t, each cell exchanges at most t courant_rate of its area with its
///       neighbours: half the sum of |psi(q) - psi(p)| over its edges pq, divided by its area.
///   (3) The velocity and the tracer are 0 everywhere if and only if `at_rest`.
struct CellFlow {
    /// The velocity at the centroid of each cell, without walls less the mean, length / second.
    std::vector<plane::Vec2> velocity = {};
    /// The stream function at the centroid of each cell less the mean, divided by its largest
    /// value. The flow carries it along its own contours, so it decays by diffusion alone, as
    /// exp(-D rate t) with the diffusivity D and the rate of the flow, as long as the flow
    /// keeps_shape().
    std::vector<double> tracer = {};
    /// OpenFOAM's largest Courant number is this times the time step, 1 / second.
    double courant_rate;
    /// The cells cannot represent the flow: they hold less than kLeastEnergy times its kinetic
    /// energy, or differences between neighbouring cells damp it at less than kLeastDamping times
    /// its rate.
    bool at_rest = false;
    /// The flow would cross the holes of the tile, so that it starts at rest.
    bool has_holes = false;

    static constexpr double kLeastEnergy = 0.5;
    static constexpr double kLeastDamping = 0.75;
};

/// Example usage:
///   const DecayingFlow flow(tile.lattice, tile.walls);
///   const CellFlow cells = cell_flow(flow, tile, extruded_mesh(tile));
///   const double time_step = 0.5 / cells.courant_rate;
///
/// @param extruded  extruded_mesh(tile), whose upright faces and patches name the neighbours.
CellFlow cell_flow(const DecayingFlow& flow, const plane::Tile& tile, const ExtrudedMesh& extruded);

}  // namespace pcvt
