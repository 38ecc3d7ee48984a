#pragma once

#include <string>

#include "mesher/finite_volume/decaying_flow.hpp"
#include "mesher/finite_volume/extruded_mesh.hpp"

namespace pcvt {

/// The files of an OpenFOAM case beside its mesh: a run of icoFoam from `flow`, with the viscosity
/// at which the flow falls to 1/e in its turn_time(), and with steps in which the fluid crosses a
/// tenth of the mean spacing.
std::string foam_control(const DecayingFlow& flow, double spacing);
std::string foam_schemes();
std::string foam_solution();
std::string foam_transport(const DecayingFlow& flow);

/// U: the flow at the centroid of each cell. p: 0.
std::string foam_velocity(const DecayingFlow& flow, const ExtrudedMesh& extruded, const Tile& tile);
std::string foam_pressure(const ExtrudedMesh& extruded);

}  // namespace pcvt
