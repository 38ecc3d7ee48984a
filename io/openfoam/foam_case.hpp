#pragma once

#include <string>

#include "mesher/finite_volume/cell_flow.hpp"
#include "mesher/finite_volume/decaying_flow.hpp"
#include "mesher/finite_volume/extruded_mesh.hpp"

namespace pcvt {

/// Return the files of an OpenFOAM case beside its mesh. A run takes `end` seconds, and
/// `courant_rate`, 1 / second, times the length of its steps is the Courant number. icoFoam and
/// pimpleFoam start from the velocity of `cells`, with the viscosity at which the flow falls to 1/e
/// within its turn_time(); scalarTransportFoam carries the tracer, with the same diffusivity;
/// potentialFoam starts from any velocity. On walls the velocity is 0, and p and T have no
/// gradient. The largest Courant number of the first step is at most 0.5.
///
/// Example usage:
///     const DecayingFlow flow(tile.lattice, tile.walls);
///     const CellFlow cells = cell_flow(flow, tile, extruded);
///     files.push_back({"tile.foam/system/controlDict", foam_control(flow.turn_time(),
///     cells.courant_rate)}); files.push_back({"tile.foam/0/U", foam_velocity(cells, extruded)});
std::string foam_control(double end, double courant_rate);
std::string foam_schemes();
std::string foam_solution();
std::string foam_transport(const DecayingFlow& flow, const CellFlow& cells);
std::string foam_turbulence();
std::string foam_velocity(const CellFlow& cells, const ExtrudedMesh& extruded);
std::string foam_pressure(const ExtrudedMesh& extruded);
std::string foam_tracer(const CellFlow& cells, const ExtrudedMesh& extruded);

}  // namespace pcvt
