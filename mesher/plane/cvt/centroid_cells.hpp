#pragma once

#include "mesher/cvt/centroid_figures.hpp"
#include "mesher/plane/cvt/area_cvt.hpp"

namespace pcvt::plane {

/// The power cells of prescribed areas and centroids.
struct CentroidCells {
    /// As compute_area_cvt() returns it; residuals are those of the centroids.
    AreaCvtResult grains;
    CentroidFigures centroids;
};

/// Finds the power diagram whose cells have prescribed areas and, as nearly as it can, prescribed
/// centroids: measured grains (centroid_fit.hpp).
///
/// Example usage:
///
///     const CentroidCells cells = fit_areas_and_centroids(
///         lattice, centroids, {.areas = areas, .run = {.tolerance = 1e-6}});
///     const double misfit = cells.centroids.mean;
///
/// Laws, tested by number:
///   (1) The areas are those of options.areas, as in compute_area_cvt().
///   (2) The cells of a power diagram are found from their areas and centroids.
///   (3) The figures are the distances of the centroids of the cells from those prescribed.
///   (4) Any two sites of the result are at least kNearestSites h from each other.
///
/// @param centroids  2 x n, length units; need not be wrapped.
/// @param options    areas; the sites are numbered as given. The run converges once every centroid
///                   is within the tolerance, in units of h; max_iterations limits the iterations
///                   of L-BFGS.
/// @throws as compute_area_cvt does.
CentroidCells fit_areas_and_centroids(const Lattice& lattice, const Points& centroids,
                                      const AreaCvtOptions& options);

}  // namespace pcvt::plane
