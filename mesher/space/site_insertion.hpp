#pragma once

#include <optional>

#include "mesher/space/torus_tetrahedra.hpp"

namespace pcvt {

/// The periodic Delaunay triangulation without mirrors: a well spread sample of the sites is
/// triangulated by space_mirrors(), then the other sites are inserted (growing_tetrahedra.hpp).
///
/// Example usage:
///
///     std::optional<TorusTetrahedra> torus = inserted_tetrahedra(sites);
///     if (!torus) torus.emplace(sites.n_sites(), space_mirrors(sites).tetrahedra);
///
/// @returns the tetrahedra sorted by their smallest site; nullopt if the sites are too few or too
///          unevenly spread: if the spheres of the sample extend by half a period or more in a
///          reduced coordinate.
std::optional<TorusTetrahedra> inserted_tetrahedra(const SpaceSites& sites);

}  // namespace pcvt
