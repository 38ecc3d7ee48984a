#pragma once

#include <string>

#include "io/formats/space_file_proof.hpp"
#include "io/run_files/area_reader.hpp"
#include "io/voxels/vti_reader.hpp"

namespace pcvt::checks {

/// Compares the volumes of proved polyhedra with the target volumes.
///
/// Example usage:
///     line += prove_cell_volumes(prove_space_files(files),
///     read_volumes(volume_table("grains.txt")));
///
/// @returns the end of a line of proof.
/// @throws NotATile      naming the cell with another volume.
/// @throws UnusableFile  the table is not for its cells.
std::string prove_cell_volumes(const SpaceFileProof& proof, const AreaFile& wanted);

/// The same for the cells of the sites of a voxel image, built from nothing.
/// @throws UnusableFile  also where the file states no sites.
std::string prove_voxel_volumes(const std::string& path, const SpaceVoxels& voxels,
                                const AreaFile& wanted);

}  // namespace pcvt::checks
