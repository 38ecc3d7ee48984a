#pragma once

#include <optional>

#include "mesher/space/delaunay/torus_tetrahedra.hpp"

namespace pcvt::space {

/// The periodic Delaunay triangulation without mirrors: a well spread sample of the sites is
/// triangulated by mirror_diagram(), then the other sites are inserted (growing_tetrahedra.hpp).
///
/// Example usage:
///
///     std::optional<TorusTetrahedra> torus = inserted_tetrahedra(sites);
///     if (!torus) torus.emplace(sites.n_sites(), mirror_diagram(sites).tetrahedra);
///
/// @returns the tetrahedra sorted by their smallest site; nullopt if the sites are too few or too
///          unevenly spread: if the spheres of the sample extend by half a period or more in a
///          reduced coordinate.
std::optional<TorusTetrahedra> inserted_tetrahedra(const Sites& sites);

}  // namespace pcvt::space
