#pragma once

#include "io/surfaces/surface_list.hpp"
#include "io/tiles/encoded_file.hpp"

namespace pcvt {

/// The files of an OBJ of surfaces: itself, and its materials.
std::vector<std::string> surface_obj_paths(const std::string& path);

/// Encodes surfaces as Wavefront OBJ: a group for each cell or each side of the seam, whose
/// material is its colour. Cells share their points. Comments that begin with "# pcvt" hold:
///
///     kind polyhedra|boundary
///     lattice ax ay az bx by bz cx cy cz
///     site x y z             the site of each cell of the tile, in their order
///     cells s s s ...        the cell behind each face; of a boundary
///     face_pair f g i j k    face f + i a + j b + k c is face g; of a boundary
///
/// Example usage:
///     const auto files = encode_surface_obj(surface_list(tile, SurfaceForm::kCells), "tile.obj");
std::vector<EncodedFile> encode_surface_obj(const SurfaceList& list, const std::string& path);

}  // namespace pcvt
