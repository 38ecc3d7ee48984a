#pragma once

#include <vector>

#include "mesher/space/delaunay/periodic_delaunay.hpp"
#include "mesher/space/geometry/metric.hpp"
#include "mesher/space/voxels/voxel_grid.hpp"

namespace pcvt::space {

/// The cells of a torus as an image: the site of each voxel.
struct VoxelImage {
    VoxelGrid grid;
    /// The site of voxel (k, l, m) is site[(m counts.y + l) counts.x + k].
    std::vector<SiteId> site;
};

/// Labels each voxel with the site to whose image its centre is nearest, in the power distance
/// |p - x|^2 - w, in the metric of elongated cells.
///
/// The centres are rounded to multiples of 2^-50 of the periods of the sites, as the sites are, and
/// distances are compared exactly. A centre that is equally far from several sites belongs to the
/// one with the smallest id.
///
/// A walk along each row of voxels goes from cell to cell: a site that is nearer to a centre than
/// all its neighbours is the nearest one, because the triangulation is regular, and it remains so
/// up to the nearest plane between its cell and a neighbour ahead. Cost: of order
/// n_voxels + n_rows n_sites^(1/3) + n_sites.
///
/// Example usage:
///
///     const PeriodicDelaunay delaunay = periodic_delaunay(Sites(lattice, points));
///     const VoxelImage image =
///         voxel_image(delaunay, {}, voxel_grid(lattice, {0, 0, 0}, {64, 64, 64}), n_threads);
///
/// Laws, tested by number:
///   (1) No other image of a site is nearer to the centre of a voxel, and none that is as near has
///       a smaller id.
///   (2) A grid of a repeated domain repeats the image.
///   (3) The image does not depend on the number of threads.
///
/// @param delaunay  of the sites mapped by `metric`; its tetrahedra are regular for the weights.
/// @param weights   length^2, one a site; empty: all are equal.
/// @param grid      its periods are vectors of the lattice of the sites.
VoxelImage voxel_image(const PeriodicDelaunay& delaunay, const Eigen::VectorXd& weights,
                       const VoxelGrid& grid, int n_threads, const Metric& metric = {});

}  // namespace pcvt::space
