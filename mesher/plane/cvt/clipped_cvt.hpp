#pragma once

#include "mesher/optimize/objective.hpp"
#include "mesher/plane/geometry/polygon.hpp"
#include "mesher/plane/geometry/sites.hpp"

namespace pcvt::plane {

/// One Voronoi cell of the standard, non-periodic diagram, clipped to the domain.
struct ClippedCell {
    /// Corners counter-clockwise, length units.
    Polygon polygon;
    /// Whether one of its sides lies on the border of the domain.
    bool meets_border = false;
};

/// Computes the Voronoi cells of the points in the plane (no images), clipped to the parallelogram
/// that the period vectors span from the origin. The cells follow the order of the points.
///
/// Example usage:
///   const Lattice unit = Lattice::rectangle(1, 1);
///   for (const ClippedCell& cell : clipped_cells(unit, uniform_points(unit, 100, 1))) {
///       if (!cell.meets_border) inner_area += polygon_area(cell.polygon);
///   }
///
/// Laws, tested by number:
///   (1) The areas of the cells sum to that of the domain.
///   (2) No other point is nearer to a corner of a cell than the point of that cell.
/// Cost: about linear in n where the points are spread evenly over the domain.
/// @param points  2 x n, n >= 1, length units, all in the closed domain.
/// @throws InvalidInput    there is no point, or one lies outside the domain.
/// @throws DuplicateSites  two points are equal.
std::vector<ClippedCell> clipped_cells(const Lattice& lattice, const Points& points);

/// The standard CVT energy on the domain (paper, Eqs. 1 and 2) for rho = 1.
struct ClippedEnergy {
    /// sum_i integral over cell i of |p - x_i|^2, length^4.
    double value = 0;
    /// 2 x n, dF/dx_i = 2 m_i (x_i - g_i), length^3.
    Points gradient;
    /// Areas of the cells, length^2.
    Eigen::VectorXd mass;
};

/// Evaluates the energy of the clipped cells. Takes the parameters and throws the errors of
/// clipped_cells.
ClippedEnergy clipped_energy(const Lattice& lattice, const Points& points);

struct ClippedCvtOptions {
    /// The run has converged once every |x_i - g_i| / h is at most this, h = sqrt(area / n).
    double tolerance = 1e-6;
    /// Negative: no limit.
    int max_iterations = -1;
    /// Reports values in length^4.
    ProgressCallback progress = {};
};

/// A standard CVT and the figures of the run that computed it.
struct ClippedCvt {
    /// 2 x n, length units, in the order of the input.
    Points sites;
    /// Energy in length^4, residual max |x_i - g_i| / h.
    RunStatistics run;
};

/// Computes the standard CVT that the paper compares with, by L-BFGS on the clipped energy. The
/// line search shortens a step that would move a site out of the domain. Takes the points and
/// throws the errors of clipped_cells.
ClippedCvt compute_clipped_cvt(const Lattice& lattice, const Points& points,
                               const ClippedCvtOptions& options);

}  // namespace pcvt::plane
