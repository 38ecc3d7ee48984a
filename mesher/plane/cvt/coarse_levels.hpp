#pragma once

#include <cmath>
#include <optional>

#include "mesher/cvt/coarse_levels.hpp"
#include "mesher/plane/cvt/cvt.hpp"
#include "mesher/torus/walls.hpp"

namespace pcvt::plane {

/// The value of CvtOptions::precondition_below for a run that begins with a coarse start, in which
/// long waves have converged already.
inline constexpr double kPreconditionAfterCoarse = 3e-3;

struct CoarseStartOptions {
    /// The threads and the callback, as CoarseLevels takes them.
    RunOptions run = {};
    /// `nullopt`: rho = 1. With a density, shakes are proportional to the local spacing.
    std::optional<Density> density = {};
};

/// The ratio of h to the distance between neighbours in a hexagonal arrangement.
inline const double kSpacingPerEdge = std::sqrt(std::sqrt(3.0) / 2);

/// The midpoints of edges quadruple the number of sites, at most twice. More levels lead to lower
/// minima, but the last optimisation then takes longer.
inline constexpr LevelGrowth kLevelGrowth{
    .dimension = 2, .factor = 4, .coarsest = 16, .most_levels = 3};

/// Returns the options of the run on the level at which a coarse start is.
///
/// Example usage:
///   CoarseLevels levels(kLevelGrowth, {.n_orbits = n}, seed, options.run);
///   Points points = uniform_points(lattice, levels.n_coarsest(), seed);
///   while (levels.next()) {
///       const CvtResult result = compute_cvt(lattice, points, level_options(levels, options));
///       points = refined(result, levels.n_finer(), levels.seed());
///   }
CvtOptions level_options(CoarseLevels& levels, const CoarseStartOptions& options);

}  // namespace pcvt::plane
