#pragma once

#include "mesher/cvt/site_constraints.hpp"
#include "mesher/cvt/solvers.hpp"
#include "mesher/plane/delaunay/moving_delaunay.hpp"
#include "mesher/plane/density/density.hpp"
#include "mesher/plane/symmetry/symmetric_objective.hpp"

namespace pcvt::plane {

/// Statistics specific to a run with a density.
struct DensityFigures {
    /// The extremes of rho over all places where it was evaluated.
    double least = 0;
    double greatest = 0;
    /// Density evaluations per site in one evaluation of F and its gradient.
    double evaluations_per_site = 0;
    /// The sum of the cells' masses, density x length^2, and its relative deviation from the
    /// integral of rho over the domain by an independent quadrature.
    double mass = 0;
    double mass_deviation = 0;
    /// The comparison with Gersho's law (gersho_scaling.hpp); the energy in density x length^4.
    double spacing_deviation = 0;
    double expected_energy = 0;
    /// The largest estimated quadrature error of a centroid, in units of the square root of its
    /// cell's area, and the number of cells where no rule reaches the required accuracy. The
    /// density is not smooth in those cells, so their centroids are at best as accurate as this
    /// error.
    double quadrature_error = 0;
    int n_rough_cells = 0;
};

struct DensityCvtOptions {
    /// A solver of the table in solvers.hpp. The Hessian is available only where h is at most an
    /// eighth of a period: in longer cells the quadrature rules on the edges would not resolve the
    /// density.
    Minimize minimize = solver_row(Solver::kLbfgs).minimize_density;
    OptimizerOptions optimizer;
    /// The result of tie_orbits() for a density with the symmetry of the orbits; nullptr: none.
    const OrbitEmbedding* orbits = nullptr;
    SiteConstraints<MovingDelaunay> constraints = {};
};

struct DensityCvtResult {
    /// Energy in density x length^4.
    RunStatistics run;
    DensityFigures figures;
};

/// Minimises the CVT energy of a density; `delaunay` ends as the triangulation of the minimiser.
///
/// Example usage:
///   MovingDelaunay delaunay(Sites(lattice, points));
///   DensityCvtOptions options;
///   options.optimizer.max_move = 0.5 * delaunay.spacing();
///   const auto [run, figures] =
///       minimize_density_energy(delaunay, workers, lattice, density, options);
///
/// The minimisation proceeds in rounds; each round reduces the target residual by a factor of 100.
/// At the start of a round the quadrature order of each cell is chosen so that the quadrature error
/// is far below the target residual, and the variables are scaled by the local spacing l_i, which
/// is proportional to rho^(-1/4): z_i = (h / l_i) x_i. The step limit options.optimizer.max_move is
/// therefore relative to the local spacing of each site, and the stiffness against long waves is
/// uniform, so the preconditioner for rho = 1 applies (long_waves.hpp). The last round is repeated
/// until the rules of all cells still reach the required accuracy at its end.
/// @param options  lengths in the unit of the triangulation; progress reports values in density x
///                 length^4.
/// @throws BadDensity naming the place where rho is invalid, or if the contrast of rho is too
///         large.
DensityCvtResult minimize_density_energy(MovingDelaunay& delaunay, Workers& workers,
                                         const Lattice& lattice, const Density& density,
                                         const DensityCvtOptions& options);

}  // namespace pcvt::plane
