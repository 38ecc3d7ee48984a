#pragma once

#include <cstddef>

#include "mesher/space/geometry/lattice.hpp"
#include "mesher/torus/voxels.hpp"

namespace pcvt::space {

/// A periodic grid of voxels with edges along x, y and z: voxel (k, l, m) is centred at
/// corner + ((k + 1/2) size.x / counts.x, and so on along y and z), 0 <= k < counts.x.
struct VoxelGrid {
    /// The corner with the least coordinates, length units.
    Vec3 corner;
    /// The periods along x, y and z, length units.
    Vec3 size;
    VoxelCounts counts;

    std::size_t n_voxels() const {
        return static_cast<std::size_t>(counts.x) * counts.y * counts.z;
    }
    /// The sides of a voxel.
    Vec3 spacing() const { return {size.x() / counts.x, size.y() / counts.y, size.z() / counts.z}; }
};

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
