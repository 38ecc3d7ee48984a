#pragma once

#include "mesher/lattice/polygon.hpp"
#include "mesher/lattice/sites.hpp"
#include "mesher/optimize/objective.hpp"

namespace pcvt {

/// One Voronoi cell of the standard, non-periodic diagram, clipped to the domain.
struct ClippedCell {
    /// Corners counter-clockwise, length units.
    Polygon polygon;
    /// Whether one of its sides lies on the border of the domain.
    bool meets_border = false;
};

/// The Voronoi cells of the points in the plane (no images), clipped to the parallelogram of the
/// period vectors with its corner at the origin; in the order of the points. Laws, tested by
/// number:
///   (1) The areas of the cells sum to that of the domain.
///   (2) No other point is nearer to any corner of a cell than its own.
/// Cost: about linear in n for points that are spread over the domain.
/// @param points  2 x n, n >= 1, length units, all in the closed domain.
/// @throws InvalidInput    no point, or one that lies outside of the domain.
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

/// Parameters and errors as for clipped_cells.
ClippedEnergy clipped_energy(const Lattice& lattice, const Points& points);

struct ClippedCvtOptions {
    /// Largest |x_i - g_i| / h at which the run has converged, h = sqrt(area / n).
    double tolerance = 1e-6;
    /// Negative: no limit.
    int max_iterations = -1;
    /// Values in length^4.
    ProgressCallback progress = {};
};

/// A standard CVT and how it was reached.
struct ClippedCvt {
    /// 2 x n, length units, in the order of the input.
    Points sites;
    Stop stop;
    int iterations;
    int evaluations;
    /// length^4.
    double energy;
    /// max |x_i - g_i| / h.
    double residual;
};

/// The standard CVT that the paper compares with: L-BFGS on the clipped energy. A step that would
/// take a site out of the domain is tried shorter. Parameters and errors as for clipped_cells.
ClippedCvt compute_clipped_cvt(const Lattice& lattice, const Points& points,
                               const ClippedCvtOptions& options);

}  // namespace pcvt
