#pragma once

#include <Eigen/Core>

#include "mesher/cells/empty_cells.hpp"
#include "mesher/space/cvt/cvt.hpp"

namespace pcvt::space {

/// A power diagram of given sites and weights.
struct WeightedCells {
    /// The regular triangulation, with the weights as given.
    PeriodicDelaunay delaunay;
    /// The volumes of the cells by site, length^3.
    Eigen::VectorXd cell_volumes;
    /// The energy, length^5, and the residuals of the cells; the run has no iterations.
    RunStatistics run;
};

/// Computes the power diagram (Laguerre diagram) of sites that stay where they are: cell i is where
/// |p - x_i|^2 - w_i is least. With w_i = r_i^2 it is the diagram of balls of radius r_i.
///
/// Example usage:
///   const Eigen::VectorXd weights = radii.array().square();
///   const WeightedCells cells = weighted_cells(lattice, points, weights, {.n_threads = 4});
///
/// Laws, tested by number:
///   (1) With equal weights, the cells are the Voronoi cells.
///   (2) A number that is added to all weights changes no cell.
///   (3) The sites that EmptyCells names are those that the power diagram of all copies lacks, as
///       far as it names them.
///
/// @param points   3 x n, length units; need not be wrapped.
/// @param weights  of each point, length^2.
/// @param run      the tolerance that decides whether the run has converged, and the threads.
/// @throws InvalidInput  unless there is one finite weight for each point; EmptyCells.
/// @throws InvalidInput and DuplicateSites as compute_cvt does.
WeightedCells weighted_cells(const Lattice& lattice, const Points& points,
                             const Eigen::VectorXd& weights, const RunOptions& run);

}  // namespace pcvt::space
