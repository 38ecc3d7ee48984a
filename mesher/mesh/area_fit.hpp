#pragma once

#include <Eigen/Core>
#include <functional>

#include "mesher/lattice/metric.hpp"
#include "mesher/mesh/periodic_mesh.hpp"

namespace pcvt {

/// The area of the faces of each site, length^2.
Eigen::VectorXd areas_by_site(const PeriodicMesh& mesh, int n_sites);

/// Returns the area of each site in the mesh that is made of some cells.
using AreaMeasure = std::function<Eigen::VectorXd(const PeriodicMesh&)>;

/// Cells with joined corners, and the weights by which each has its area again.
struct FittedCells {
    PeriodicMesh cells;
    /// length^2, one a site.
    Eigen::VectorXd weights;
    /// The largest |area - wish| / wish, in the measure.
    double largest_relative_error;
};

/// Gives power cells back the areas that they had before their short edges were removed.
///
/// A corner of k cells lies at the mean of the dual vertices of its sites (dual_mean.hpp), which
/// depends on their weights. So the areas of joined cells, too, are functions m(w) of the weights;
/// w becomes w + A^-1 (a - m(w)) with A the Laplacian of the cells, which is the derivative of
/// their areas before corners were joined, until m(w) = a. As corners were joined, A is not the
/// derivative of m near them; the steps of several iterations together make up for that (D. G.
/// Anderson 1965, the generalised minimal residual method for linear m).
///
/// Example usage:
///   const PeriodicMesh cells = cell_mesh(delaunay);
///   const FittedCells fitted =
///       fit_areas(cells, without_short_edges(cells, 0.02 * h), Metric(), delaunay.weights(),
///                 [&](const PeriodicMesh& mesh) { return areas_by_site(mesh, n); });
///
/// Laws, tested by number:
///   (1) Topology, frames and sites are those of `joined`; all faces are simple polygons.
///   (2) Each vertex is the dual_mean() of the sites round it with the weights of the result.
///   (3) The areas are those of `cells`, to the tolerance of the run that computed the weights, for
///       cells of a whole outline.
///
/// @param cells    whole power cells, the plane: one a site, or a site's cell or parts of cells
///                 between walls with their mirror images (mirrored_mesh()).
/// @param joined   the same cells without short edges.
/// @param metric   in which they are power cells.
/// @param weights  n, length^2, of the round space of the metric.
/// @param measure  of all faces of a site; where corners are moved later, as at the sides of a box:
///                 of the result of that.
/// @returns `joined` and `weights` themselves if the areas agree already, or cannot be improved.
FittedCells fit_areas(const PeriodicMesh& cells, PeriodicMesh joined, const Metric& metric,
                      const Eigen::VectorXd& weights, const AreaMeasure& measure);

}  // namespace pcvt
