#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <string>
#include <vector>

#include "mesher/base/checkpoint.hpp"
#include "mesher/base/law_violation.hpp"
#include "mesher/base/site_id.hpp"

namespace pcvt {

/// Voxels along x, y and z. In the plane, the layers along z are equal.
struct VoxelCounts {
    int x = 0;
    int y = 0;
    int z = 1;

    friend bool operator==(const VoxelCounts&, const VoxelCounts&) = default;
};

/// A periodic grid of voxels with edges along the axes of D dimensions: voxel (k, l, ...) is
/// centred at corner + ((k + 1/2) size.x / counts.x, (l + 1/2) size.y / counts.y, ...), 0 <= k <
/// counts.x.
template <int D>
struct VoxelGrid {
    using Vec = Eigen::Matrix<double, D, 1>;

    /// The corner with the least coordinates, length units.
    Vec corner;
    /// The periods along the axes, length units.
    Vec size;
    VoxelCounts counts;

    /// The number of voxels; in the plane of one layer.
    std::size_t n_voxels() const {
        return static_cast<std::size_t>(counts.x) * counts.y * (D == 3 ? counts.z : 1);
    }
    /// The sides of a voxel.
    Vec spacing() const {
        const double n[] = {double(counts.x), double(counts.y), double(counts.z)};
        return size.array() / Eigen::Map<const Vec>(n).array();
    }
};

/// The sites whose cells an image shows.
template <class Lattice, class Metric>
struct VoxelCells {
    /// The period vectors of the sites, in the frame of the image.
    Lattice lattice;
    /// D x n, length units; need not be wrapped.
    typename Lattice::Points sites;
    /// length^2, one a site; empty without weights.
    Eigen::VectorXd weights = {};
    /// Elongated cells: the metric in which they are the cells of their sites.
    Metric metric = {};

    int n_cells() const { return static_cast<int>(sites.cols()); }
};

/// Solvers by Fourier transforms refuse a single voxel along x.
inline constexpr int kLeastVoxels = 2;
inline constexpr int kMostVoxelsOfARow = 1 << 20;
inline constexpr int kMostVoxels = 1 << 28;

/// The smallest even number of voxels along an axis that is not below `wanted`, within the limits
/// of an axis.
///
/// Example usage:
///   const int n = even_voxel_count(15.2);  // 16
int even_voxel_count(double wanted);

/// @throws LimitExceeded  there are more than kMostVoxels voxels, or kMostVoxelsOfARow along an
///                        axis.
void require_voxel_limits(VoxelCounts counts);

/// The result of prove_voxels().
struct VoxelProof {
    int n_cells;
    /// The cells that contain the centre of no voxel, by rising id.
    std::vector<SiteId> unseen;
    /// The largest distance of a centre from the cell that it names, in units of h.
    double largest_excess;
};

/// In units of h, the square root of area / n or the cube root of volume / n: a centre may lie so
/// far outside of the cell that it names, because positions are rounded in files.
inline constexpr double kVoxelTolerance = 1e-9;

/// Requires that each voxel names a site from 0 to n_cells - 1.
/// @param name_of  returns the name of a voxel by its index.
/// @throws NotATile naming the first voxel that does not.
template <class NameOf>
void require_voxel_ids(const std::vector<SiteId>& sites, int n_cells, const NameOf& name_of) {
    for (std::size_t k = 0; k < sites.size(); ++k) {
        checkpoint_each(static_cast<long>(k));
        if (sites[k] >= 0 && sites[k] < n_cells) continue;
        throw NotATile(name_of(k) + " names cell " + std::to_string(sites[k]) +
                       ", but the cells are 0 to " + std::to_string(n_cells - 1));
    }
}

/// The cells 0 ... n_cells - 1 that no voxel names.
/// @param sites  those of the voxels, from 0 to n_cells - 1.
std::vector<SiteId> unseen_cells(const std::vector<SiteId>& sites, int n_cells);

}  // namespace pcvt
