#pragma once

#include <string>
#include <vector>

#include "io/space/space_tile.hpp"
#include "io/tiles/encoded_file.hpp"

namespace pcvt {

/// The comment in the boundary file of a case of polyhedra.
inline constexpr const char* kSpaceKind = "// pcvt kind polyhedra\n";

/// Returns the paths of the files in the case folder `folder`, in the order of
/// encode_space_foam().
std::vector<std::string> space_foam_paths(const std::string& folder);

/// Encodes a tile of polyhedra as a case folder for OpenFOAM that icoFoam and pimpleFoam run
/// without further input: two cyclic patches, seam_I_J_K and seam_-I_-J_-K, for each translation,
/// and as the initial state a BeltramiFlow at the centroids of the cells, which falls to 1/e by the
/// end of the run. An empty file with the name of the folder opens the case in ParaView.
///
/// Cell s is the cell of site s. Comments in the boundary file hold the period vectors and the
/// images of the sites.
///
/// Example usage:
///     output.stage_folder("tile.foam");
///     for (const EncodedFile& file : encode_space_foam(tile, "tile.foam")) {
///         output.stage(file.path, file.bytes);
///     }
///
/// @throws InternalError if a coordinate is not finite.
std::vector<EncodedFile> encode_space_foam(const SpaceTile& tile, const std::string& folder);

}  // namespace pcvt
