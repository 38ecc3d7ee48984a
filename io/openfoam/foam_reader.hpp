#pragma once

#include <vector>

#include "io/bytes/encoded_file.hpp"
#include "mesher/cells/finite_volume_mesh.hpp"

namespace pcvt {

/// Reads the mesh of an OpenFOAM case. Only files in constant/polyMesh are read, in any order
/// within `files`. Nothing is proved but that each cyclic patch has a name, an offset and a
/// partner; n_cells is not set.
///
/// Example usage:
///     const FiniteVolumeMesh mesh = decode_foam_mesh(files, 2);
///     require_face_order(mesh, "(2) of extruded meshes, faces");
///
/// @param n_periods  2 or 3: the numbers in the names of cyclic patches, and those of a separation
///                   that may differ from 0.
/// @throws BadFile  if a file is missing or is not in OpenFOAM's ASCII format, or a patch is
/// neither
///                  empty, a wall nor cyclic.
FiniteVolumeMesh decode_foam_mesh(const std::vector<EncodedFile>& files, int n_periods);

}  // namespace pcvt
