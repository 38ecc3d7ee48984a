#pragma once

#include <optional>

#include "mesher/delaunay/moving_delaunay.hpp"
#include "mesher/density/density.hpp"
#include "mesher/optimize/lbfgs_newton.hpp"
#include "mesher/optimize/objective.hpp"

namespace pcvt {

/// How a run with a density went, beside what all runs tell.
struct DensityFigures {
    /// The extremes of rho wherever it was asked.
    double least = 0;
    double greatest = 0;
    /// Density evaluations in one evaluation of F and its gradient, over the number of sites.
    double evaluations_per_site = 0;
    /// Sum of the cells' masses, density x length^2; and how much it differs from the integral of
    /// rho over the domain by another quadrature, relatively.
    double mass = 0;
    double mass_deviation = 0;
    /// See spacing_law.hpp; the energy in density x length^4.
    double spacing_deviation = 0;
    double expected_energy = 0;
    /// Largest estimated error of a centroid by the quadrature, in units of the square root of its
    /// cell's area, and the number of cells where no rule reaches the accuracy: the density is not
    /// smooth there, so centroids are not known better than that.
    double quadrature_error = 0;
    int n_rough_cells = 0;
};

struct DensityCvtOptions {
    /// Whether Lloyd's iteration is to be used in place of all others.
    bool lloyd = false;
    /// When Newton's method takes turns with L-BFGS (relay.hpp); nothing: never. An evaluation
    /// costs so much more than a product with the Hessian that it pays for any number of sites:
    /// measured up to 10^5, where it halves the evaluations. Only where cells are no longer than an
    /// eighth of a period: the rules on their edges could not follow the density.
    std::optional<NewtonStart> newton = NewtonStart::kNearForAnyNumber;
    OptimizerOptions optimizer;
};

struct DensityCvtResult {
    OptimizerResult run;
    DensityFigures figures;
};

/// Minimises the CVT energy of a density and leaves the triangulation at the end.
///
/// Works in rounds, each to a residual a hundred times smaller than the one before. At the
/// beginning of a round the order of each cell's rule is chosen anew, with a quadrature error far
/// below the round's residual, and the variables are scaled by the local spacing: z_i = x_i h /
/// l_i, where l_i goes with rho^(-1/4). So no site moves further in one step than options.max_move
/// of its own spacing, and all move alike; and their stiffness against long waves is the same
/// everywhere, so that these can be treated apart as for rho = 1 (long_waves.hpp). The last round
/// is repeated until the rules of all cells still reach the accuracy at its end.
/// @param options  lengths in the unit of the triangulation; values are reported in density x
///                 length^4.
/// @throws BadDensity naming the place, or for the contrast.
DensityCvtResult minimize_density_energy(MovingDelaunay& delaunay, Workers& workers,
                                         const Lattice& lattice, const Density& density,
                                         const DensityCvtOptions& options);

}  // namespace pcvt
