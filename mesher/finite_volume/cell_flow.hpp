#pragma once

#include <vector>

#include "mesher/finite_volume/beltrami_flow.hpp"
#include "mesher/finite_volume/decaying_flow.hpp"
#include "mesher/plane/tile/tile.hpp"
#include "mesher/space/mesh/polyhedral_mesh.hpp"

namespace pcvt {

/// An exact flow on the cells of a finite-volume mesh: the initial state of a solver.
///
/// Laws, tested by number:
///   (1) In the plane, the area-weighted means of the tracer and, without walls, of the velocity
///   are
///       0.
///   (2) During a time t, each cell exchanges at most t courant_rate of its measure with its
///       neighbours: half the sum of |flux| over its faces, divided by its measure. In the plane
///       the flux is exact, |psi(q) - psi(p)| over an edge pq; in space it is that of the velocity
///       at the mean of the corners.
///   (3) The velocity and the tracer are 0 everywhere if and only if `at_rest`.
struct CellFlow {
    /// At the centroid of each cell, length / second; z = 0 in the plane.
    std::vector<Eigen::Vector3d> velocity = {};
    /// A scalar that the flow carries along its own contours, so that it decays only by diffusion,
    /// as exp(-D rate t) with the diffusivity D, as long as the flow keeps_shape. In the plane the
    /// stream function less the mean, divided by its largest value; in space empty.
    std::vector<double> tracer = {};
    /// OpenFOAM's largest Courant number is this times the time step, 1 / second.
    double courant_rate = 0;
    /// As the functions of the exact flow with these names.
    double rate;
    double turn_time;
    bool keeps_shape = true;
    /// The cells cannot represent the flow: they hold less than kLeastEnergy times its kinetic
    /// energy, or differences between neighbouring cells damp it at less than kLeastDamping times
    /// its rate.
    bool at_rest = false;
    /// The flow would cross the holes of the tile, so that it starts at rest.
    bool has_holes = false;

    static constexpr double kLeastEnergy = 0.5;
    static constexpr double kLeastDamping = 0.75;
};

/// The flow on the prisms over a tile. It falls to 1/e in time only if the cells resolve its waves,
/// and a solver without walls conserves the mean velocity. So the mean is subtracted, and cells
/// that are too large for the flow start at rest. Walls take up momentum; between walls the mean
/// velocity stays.
///
/// Example usage:
///   const CellFlow flow = cell_flow(DecayingFlow(tile.lattice, tile.walls), tile, extruded);
///   const double time_step = 0.5 / flow.courant_rate;
///
/// @param extruded  extruded_mesh(tile), whose upright faces and patches name the neighbours.
CellFlow cell_flow(const DecayingFlow& flow, const plane::Tile& tile,
                   const FiniteVolumeMesh& extruded);

/// The flow on polyhedra, however large they are.
CellFlow cell_flow(const BeltramiFlow& flow, const space::PolyhedralMesh& mesh);

}  // namespace pcvt
