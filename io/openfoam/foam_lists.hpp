#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "io/tiles/encoded_file.hpp"
#include "mesher/base/faces.hpp"

namespace pcvt {

/// Returns constant/polyMesh/`name` among the files of a case.
///
/// Example usage:
///     const std::vector<int> owner = foam_labels(foam_mesh_file(files, "owner"));
///
/// @throws BadFile if it is missing.
const EncodedFile& foam_mesh_file(const std::vector<EncodedFile>& files, const std::string& name);

/// Read the lists of a mesh.
/// @throws BadFile  the file is not such a list in OpenFOAM's ASCII format.
std::vector<Eigen::Vector3d> foam_points(const EncodedFile& file);
Faces foam_faces(const EncodedFile& file);
std::vector<int> foam_labels(const EncodedFile& file);

}  // namespace pcvt
