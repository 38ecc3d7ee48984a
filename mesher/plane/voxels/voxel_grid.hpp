#pragma once

#include "mesher/plane/geometry/lattice.hpp"
#include "mesher/torus/voxels.hpp"

namespace pcvt::plane {

using pcvt::kLeastVoxels;
using pcvt::kMostVoxels;
using pcvt::kMostVoxelsOfARow;
using pcvt::VoxelCounts;

/// A periodic grid of rectangular voxels: voxel (k, l) is centred at
/// corner + ((k + 1/2) size.x / counts.x, (l + 1/2) size.y / counts.y), 0 <= k < counts.x.
struct VoxelGrid {
    /// The lower left corner, length units.
    Vec2 corner;
    /// The periods along x and y, length units.
    Vec2 size;
    VoxelCounts counts;

    /// The number of voxels of one layer.
    std::size_t n_voxels() const { return static_cast<std::size_t>(counts.x) * counts.y; }
    /// The sides of a voxel.
    Vec2 spacing() const { return {size.x() / counts.x, size.y() / counts.y}; }
};

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
