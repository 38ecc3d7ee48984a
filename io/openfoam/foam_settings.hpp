#pragma once

#include <string>

#include "io/openfoam/foam_case.hpp"

namespace pcvt {

/// Return the files of a case beside its mesh. A run takes the turn_time of the flow; icoFoam and
/// pimpleFoam start from its velocity, with the viscosity at which it falls to 1/e within that
/// time; scalarTransportFoam carries the tracer, with the same diffusivity; potentialFoam starts
/// from any velocity. On walls the velocity is 0, and p and T have no gradient. The largest Courant
/// number of the first step is at most 0.5.
///
/// Example usage:
///     files.push_back({"tile.foam/system/controlDict", foam_control(foam)});
///     files.push_back({"tile.foam/0/U", foam_velocity(foam)});
std::string foam_control(const FoamCase& foam);
std::string foam_schemes(const FoamCase& foam);
std::string foam_solution(const FoamCase& foam);
std::string foam_transport(const FoamCase& foam);
std::string foam_turbulence(const FoamCase& foam);
std::string foam_velocity(const FoamCase& foam);
std::string foam_pressure(const FoamCase& foam);
std::string foam_tracer(const FoamCase& foam);

/// The word of a patch in the boundary file: "cyclic", "wall" or "empty".
const char* foam_word(PatchKind kind);

}  // namespace pcvt
