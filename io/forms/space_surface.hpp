#pragma once

#include "io/forms/surface_list.hpp"
#include "io/forms/surface_mesh.hpp"

namespace pcvt {

/// Returns surfaces in space with their notes and colours. Its groups are the cells, each in the
/// colour that SurfaceList::colouring says, or the sides of the seam, where two that are glued have
/// one colour. The notes are lattice, sites, the cells of faces where groups do not show them, and
/// of a boundary the face that each face is glued to.
///
/// Example usage:
///     SurfaceList list = surface_list(tile.mesh, tile.sites, SurfaceForm::kCells);
///     const SurfaceMesh mesh = surface_mesh(std::move(list), SeamForm::kColumns);
SurfaceMesh surface_mesh(SurfaceList list, SeamForm seam);

}  // namespace pcvt
