#pragma once

#include <Eigen/Core>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/bytes/encoded_file.hpp"
#include "io/bytes/text.hpp"
#include "mesher/base/faces.hpp"

namespace pcvt {

/// Returns constant/polyMesh/`name` among the files of a case.
///
/// Example usage:
///     const std::vector<int> owner = foam_labels(foam_mesh_file(files, "owner"));
///
/// @throws BadFile if it is missing.
const EncodedFile& foam_mesh_file(const std::vector<EncodedFile>& files, const std::string& name);

/// Returns the boundary file of a case, all of whose files are text.
/// @throws BadFile if it is missing, or a file is binary.
const EncodedFile& foam_boundary(const std::vector<EncodedFile>& files);

/// Returns the folder of a case: "tile.foam".
/// @throws BadFile if it has no boundary file.
std::string foam_folder(const std::vector<EncodedFile>& files);

/// Takes the words of a comment `// pcvt KEY VALUES...`.
using TakeNote = std::function<void(const LineScanner& scanner, std::string_view key,
                                    std::span<const std::string_view> values)>;
/// Calls take() for each such comment of the boundary file.
void read_foam_notes(const EncodedFile& boundary, const TakeNote& take);

/// Read the lists of a mesh.
/// @throws BadFile  the file is not such a list in OpenFOAM's ASCII format.
std::vector<Eigen::Vector3d> foam_points(const EncodedFile& file);
Faces foam_faces(const EncodedFile& file);
std::vector<int> foam_labels(const EncodedFile& file);

}  // namespace pcvt
