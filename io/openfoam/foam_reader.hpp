#pragma once

#include <optional>
#include <vector>

#include "io/tiles/encoded_file.hpp"
#include "io/tiles/tile_file.hpp"

namespace pcvt {

/// Reads the tile at the back of an OpenFOAM case that is one cell thick, with the edge pairs of
/// its cyclic patches. Only files in constant/polyMesh are read, in any order within `files`.
///
/// Example usage:
///     std::vector<EncodedFile> files;
///     for (const std::string& path : foam_paths("tile.foam")) {
///         files.push_back({path, read_whole_file(path)});
///     }
///     const TileFile file = decode_foam(files, std::nullopt);
///
/// @param lattice  used if the boundary file lacks the comment `pcvt lattice`, because another
///                 program wrote it.
/// @throws BadFile  if a file is missing or is not in OpenFOAM's ASCII format.
/// @throws NotATile if the mesh violates the laws of ExtrudedMesh.
TileFile decode_foam(const std::vector<EncodedFile>& files,
                     const std::optional<plane::Lattice>& lattice);

}  // namespace pcvt
