#pragma once

#include <string>

#include "mesher/finite_volume/decaying_flow.hpp"
#include "mesher/finite_volume/extruded_mesh.hpp"

namespace pcvt {

/// Return the files of an OpenFOAM case beside its mesh. icoFoam starts from `flow`, with the
/// viscosity at which the flow falls to 1/e within its turn_time(), and with time steps in which
/// the fluid crosses at most a tenth of `spacing`.
std::string foam_control(const DecayingFlow& flow, double spacing);
std::string foam_schemes();
std::string foam_solution();
std::string foam_transport(const DecayingFlow& flow);

/// Return the initial fields: U is the flow at the centroid of each cell, p is 0.
std::string foam_velocity(const DecayingFlow& flow, const ExtrudedMesh& extruded, const Tile& tile);
std::string foam_pressure(const ExtrudedMesh& extruded);

}  // namespace pcvt
