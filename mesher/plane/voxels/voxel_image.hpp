#pragma once

#include <vector>

#include "mesher/plane/delaunay/periodic_delaunay.hpp"
#include "mesher/plane/geometry/metric.hpp"
#include "mesher/plane/voxels/voxel_grid.hpp"

namespace pcvt::plane {

/// The cells of a torus as an image: the site of each voxel of one layer, which all layers repeat.
struct VoxelImage {
    VoxelGrid grid;
    /// The site of voxel (k, l) is site[l counts.x + k].
    std::vector<SiteId> site;
};

/// Labels each voxel with the site to whose image its centre is nearest, in the power distance
/// |p - x|^2 - w where the sites have weights, and in the metric of elongated cells.
///
/// The centres are rounded to multiples of 2^-51 of the periods of the sites, as the sites are, and
/// distances are compared exactly. A centre that is equally far from several sites belongs to the
/// one with the smallest id.
///
/// A walk along each row of voxels goes from cell to cell: a site that is nearer to a centre than
/// all its neighbours is the nearest one, because the triangulation is regular. Cost: of order
/// n_voxels + n_sites for grids that are shaped as their domain.
///
/// Example usage:
///
///     const PeriodicDelaunay delaunay(Sites(lattice, uniform_points(lattice, 100, 1)));
///     const VoxelImage image =
///         voxel_image(delaunay, {}, voxel_grid(lattice, {0, 0}, {256, 256}), n_threads);
///
/// Laws, tested by number:
///   (1) No other image of a site is nearer to the centre of a voxel, and none that is as near has
///       a smaller id.
///   (2) A grid of a repeated domain repeats the image.
///   (3) The image does not depend on the number of threads.
///
/// @param delaunay  of the sites mapped by `metric`.
/// @param grid      its periods are vectors of the lattice of the sites.
VoxelImage voxel_image(const PeriodicDelaunay& delaunay, const Metric& metric,
                       const VoxelGrid& grid, int n_threads);

}  // namespace pcvt::plane
