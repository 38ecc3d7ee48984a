#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>

#include "mesher/plane/geometry/metric.hpp"
#include "mesher/plane/mesh/box_outline.hpp"
#include "mesher/plane/mesh/periodic_mesh.hpp"

namespace pcvt::plane {

/// The area of the faces of each site, length^2.
Eigen::VectorXd areas_by_site(const PeriodicMesh& mesh, int n_sites);

/// Cells with joined corners, and the weights by which each has its area again.
struct FittedCells {
    PeriodicMesh cells;
    /// length^2, one a site.
    Eigen::VectorXd weights;
    /// The largest |area - target| / target.
    double largest_relative_error;
    /// The pieces of copies of the cells, if the target areas are those in a box.
    std::optional<BoxCut> cut = {};
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
///       fit_areas(cells, without_short_edges(cells, 0.02 * h), Metric(), delaunay.weights());
///
/// Laws, tested by number:
///   (1) Topology, frames and sites are those of `joined`; all faces are simple polygons.
///   (2) Each vertex is the dual_mean() of the sites round it with the weights of the result.
///   (3) The areas are those of `cells`, to the tolerance of the run that computed the weights.
///
/// @param cells    whole power cells, the plane: one a site, or a site's cell or parts of cells
///                 between walls with their mirror images (mirrored_mesh()).
/// @param joined   the same cells without short edges.
/// @param metric   in which they are power cells.
/// @param weights  n, length^2, of the round space of the metric.
/// @returns `joined` and `weights` themselves if the areas agree already, or cannot be improved.
FittedCells fit_areas(const PeriodicMesh& cells, PeriodicMesh joined, const Metric& metric,
                      const Eigen::VectorXd& weights);

/// Returns the areas that the sites have after corners of cells were moved, or nothing.
using AreaMeasure = std::function<std::optional<Eigen::VectorXd>(const PeriodicMesh&)>;

/// The same for areas after corners are moved once more, as at the sides of a box between walls.
FittedCells fit_areas(const PeriodicMesh& cells, PeriodicMesh joined, const Metric& metric,
                      const Eigen::VectorXd& weights, const AreaMeasure& measure);

/// A box round copies of cells.
struct BoxOfCopies {
    int columns = 1;
    int rows = 1;
    Vec2 corner = Vec2::Zero();
    /// As that of cut_along_box(), length units.
    double snap = 0;
};

/// The same where the pieces of the cells in a box have the areas, on average over the copies. The
/// cut decides which vertices and edges lie on the box, the weights are fitted while this decision
/// holds, and the fitted cells are cut again: if the decision is another one then, again. Where no
/// weights are found so, the snapping distance is reduced.
FittedCells fit_areas_in_box(const PeriodicMesh& cells, const PeriodicMesh& joined,
                             const Metric& metric, const Eigen::VectorXd& weights, BoxOfCopies box);

}  // namespace pcvt::plane
