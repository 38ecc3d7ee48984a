#pragma once

#include "mesher/cvt/centroid_figures.hpp"
#include "mesher/space/cvt/volume_cvt.hpp"

namespace pcvt::space {

/// The power cells of prescribed volumes and centroids.
struct CentroidCells {
    /// As compute_volume_cvt() returns it; residuals are those of the centroids.
    VolumeCvtResult grains;
    CentroidFigures centroids;
};

/// Finds the power diagram whose cells have prescribed volumes and, as nearly as it can, prescribed
/// centroids: measured grains (centroid_fit.hpp).
///
/// Example usage:
///
///     const CentroidCells cells = fit_volumes_and_centroids(
///         lattice, centroids, {.volumes = volumes, .run = {.tolerance = 1e-6}});
///     const double misfit = cells.centroids.mean;
///
/// Laws, tested by number:
///   (1) The volumes are those of options.volumes, as in compute_volume_cvt().
///   (2) The cells of a power diagram are found from their volumes and centroids.
///   (3) The figures are the distances of the centroids of the cells from those prescribed.
///   (4) Every bit is the same for any number of threads.
///   (5) Any two sites of the result are at least kNearestSites h from each other.
///
/// @param centroids  3 x n, length units; need not be wrapped.
/// @param options    volumes; by_rank is ignored. The run converges once every centroid is within
///                   the tolerance, in units of h; max_iterations limits the iterations of L-BFGS.
/// @throws InvalidInput if two centroids are nearer than kNearestSites h to each other; else as
///         compute_volume_cvt does.
CentroidCells fit_volumes_and_centroids(const Lattice& lattice, const Points& centroids,
                                        const VolumeCvtOptions& options);

}  // namespace pcvt::space
