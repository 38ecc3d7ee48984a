#pragma once

#include "mesher/plane/voxels/voxel_image.hpp"

namespace pcvt::plane {

/// The sites whose cells an image shows.
struct VoxelCells {
    /// The period vectors of the sites, in the plane of the image.
    Lattice lattice;
    /// 2 x n, length units; need not be wrapped.
    Points sites;
    /// length^2, one a site; empty without weights.
    Eigen::VectorXd weights = {};
    Metric metric = {};

    int n_cells() const { return static_cast<int>(sites.cols()); }
};

/// The result of prove_voxels().
struct VoxelProof {
    int n_cells;
    /// The cells that contain the centre of no voxel, by rising id.
    std::vector<SiteId> unseen;
    /// The largest distance of a centre from the cell that it names, in units of h.
    double largest_excess;
};

/// In units of h = sqrt(area / n): a centre may lie so far outside of the cell that it names,
/// because positions are rounded in files.
inline constexpr double kVoxelTolerance = 1e-9;

/// Proves the image from only the positions of the sites, in doubles, without a triangulation:
///   (1) Each voxel names a site from 0 to n - 1.
///   (2) The centre of each voxel lies in the cell of the site that it names.
///   (3) The periods of the grid are translations of the lattice of the sites.
///
/// Example usage:
///   const VoxelProof proof = prove_voxels(image, cells);
///   if (!proof.unseen.empty()) warn(proof.unseen);
///
/// Cost: of order n_voxels log n.
/// @throws NotATile naming the voxel (from 0) and the site.
VoxelProof prove_voxels(const VoxelImage& image, const VoxelCells& cells);

/// The cells 0 ... n_cells - 1 that no voxel names.
/// @pre law (1).
std::vector<SiteId> unseen_cells(const VoxelImage& image, int n_cells);

/// Checks only law (1).
/// @throws NotATile
void require_voxel_ids(const VoxelImage& image, int n_cells);

}  // namespace pcvt::plane
