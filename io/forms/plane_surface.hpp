#pragma once

#include <span>

#include "io/forms/surface_mesh.hpp"
#include "mesher/plane/tile/tile.hpp"

namespace pcvt {

/// Returns a tile with its notes, without colours and texture coordinates. The notes are lattice,
/// seam, the site of each face or vertex, those of io/forms/site_notes.hpp, the edges of holes, and
/// the orbits of the sites. In columns, each vertex has its orbit, the smallest index of a vertex
/// on it, and its offset from there.
///
/// Example usage:
///     const SurfaceMesh mesh = surface_mesh(tile, SeamForm::kLines, options.site_orbits);
///
/// @param site_orbits  the orbit of each site of one period under the symmetry of the run, or none.
SurfaceMesh surface_mesh(const plane::Tile& tile, SeamForm seam,
                         std::span<const int> site_orbits = {});

}  // namespace pcvt
