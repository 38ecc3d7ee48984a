#pragma once

#include <string>

#include "io/forms/tile_file.hpp"
#include "io/run_files/area_reader.hpp"
#include "io/voxels/vti_reader.hpp"

namespace pcvt::checks {

/// Compares the areas of the power cells, built from nothing, or where corners were moved those of
/// the faces, with the target areas.
///
/// Example usage:
///     line += prove_tile_areas(path, file, proof, read_areas("grains.txt"));
///
/// @returns the end of a line of proof.
/// @throws NotATile      naming the cell with another area.
/// @throws UnusableFile  the file states no weights, or the table is not for its sites.
std::string prove_tile_areas(const std::string& path, const TileFile& file,
                             const plane::TileProof& proof, const AreaFile& wanted);

/// The same for the sites of a voxel image.
std::string prove_voxel_areas(const std::string& path, const VoxelFile& file,
                              const AreaFile& wanted);

}  // namespace pcvt::checks
