#pragma once

#include <cstddef>

#include "mesher/space/geometry/lattice.hpp"
#include "mesher/torus/voxels.hpp"

namespace pcvt::space {

using VoxelGrid = pcvt::VoxelGrid<3>;

/// The counts with about 16 voxels along h = cbrt(volume / n), even along all axes, or fewer where
/// these would be more than kMostVoxels.
/// @param n_cells  cells in the domain of `lattice`.
/// @throws InvalidInput as voxel_grid() does.
VoxelCounts default_voxels(const Lattice& lattice, double n_cells);

/// The grid that fills the box of a lattice at an origin.
///
/// Example usage:
///   const VoxelGrid grid = voxel_grid(Lattice::box(2, 1, 1), {0, 0, 0}, {200, 100, 100});
///
/// @param lattice  a box: its periods, or those of its reduced basis, lie along x, y and z, in any
///                 order and direction.
/// @throws InvalidInput   the lattice is not a box, or there are fewer than kLeastVoxels along an
///                        axis.
/// @throws LimitExceeded  there are more than kMostVoxels voxels.
VoxelGrid voxel_grid(const Lattice& lattice, const Vec3& origin, VoxelCounts counts);

}  // namespace pcvt::space
