#pragma once

#include "mesher/plane/geometry/lattice.hpp"
#include "mesher/torus/voxels.hpp"

namespace pcvt::plane {

using pcvt::kLeastVoxels;
using pcvt::kMostVoxels;
using pcvt::kMostVoxelsOfARow;
using pcvt::VoxelCounts;

using VoxelGrid = pcvt::VoxelGrid<2>;

/// The counts with about 16 voxels along h = sqrt(area / n), even in both directions.
/// @param n_cells  cells in the domain of `lattice`.
VoxelCounts default_voxels(const Lattice& lattice, double n_cells);

/// The grid that fills the domain of a lattice at an origin (mesher/plane/geometry/domain.hpp).
///
/// Example usage:
///   const VoxelGrid grid = voxel_grid(Lattice::rectangle(2, 1), {0, 0}, {200, 100});
///
/// @param lattice  rectangular, or a repetition of another lattice that is.
/// @throws InvalidInput   the lattice has no periods along x and y, there are fewer than
///                        kLeastVoxels along one of them, or no layer.
/// @throws LimitExceeded  there are more than kMostVoxels voxels in all layers.
VoxelGrid voxel_grid(const Lattice& lattice, const Vec2& origin, VoxelCounts counts);

}  // namespace pcvt::plane
