#pragma once

#include "mesher/space/voxels/voxel_image.hpp"

namespace pcvt::space {

using VoxelCells = pcvt::VoxelCells<Lattice, Metric>;

/// Proves the image from only the positions of the sites, in doubles, without a triangulation:
///   (1) Each voxel names a site from 0 to n - 1.
///   (2) The centre of each voxel lies in the cell of the site that it names, within
///       kVoxelTolerance.
///   (3) The periods of the grid are translations of the lattice of the sites.
///
/// Example usage:
///   const VoxelProof proof = prove_voxels(image, cells);
///   if (!proof.unseen.empty()) warn(proof.unseen);
///
/// Cost: of order n_voxels + n log n where a cell has some hundred voxels.
/// @throws NotATile naming the voxel (from 0) and the site.
VoxelProof prove_voxels(const VoxelImage& image, const VoxelCells& cells);

/// Checks only law (1).
/// @throws NotATile
void require_voxel_ids(const VoxelImage& image, int n_cells);

}  // namespace pcvt::space
