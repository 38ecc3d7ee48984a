#pragma once

#include <Eigen/Core>

#include "mesher/cells/empty_cells.hpp"
#include "mesher/plane/cvt/walled_cvt.hpp"

namespace pcvt::plane {

/// Computes the power diagram (Laguerre diagram) of sites that stay where they are: cell i is where
/// |p - x_i|^2 - w_i is least. With w_i = r_i^2 it is the diagram of circles of radius r_i.
///
/// Example usage:
///   const Eigen::VectorXd weights = radii.array().square();
///   const CvtResult cells = weighted_cells(lattice, points, weights, {.n_threads = 4});
///   const PeriodicMesh mesh = cell_mesh(cells.delaunay);
///
/// The result has the energy of the cells, the sum of the integrals of |p - x_i|^2, and their
/// residuals; the run has no iterations. Laws, tested by number:
///   (1) With equal weights, the cells are the Voronoi cells.
///   (2) A number that is added to all weights changes no cell.
///   (3) The sites that EmptyCells names are those that the power diagram of all copies lacks.
///
/// @param points   2 x n, length units; need not be wrapped.
/// @param weights  of each point, length^2.
/// @param run      the tolerance that decides whether the run has converged, and the threads.
/// @throws InvalidInput  unless there is one finite weight for each point, below 1e150 mean areas
///         or so; EmptyCells.
/// @throws InvalidInput and DuplicateSites as Sites and require_distinct do.
CvtResult weighted_cells(const Lattice& lattice, const Points& points,
                         const Eigen::VectorXd& weights, const RunOptions& run);

/// The same between walls: a site and its mirror images have one weight, so that the wall between
/// them is an edge of their cells.
/// @param domain  upright.
/// @throws InvalidInput  a point lies beyond a wall.
WalledCvt walled_weighted_cells(const Lattice& domain, Walls walls, const Points& points,
                                const Eigen::VectorXd& weights, const RunOptions& run);

}  // namespace pcvt::plane
