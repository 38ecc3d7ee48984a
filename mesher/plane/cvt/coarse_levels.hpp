#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <optional>

#include "mesher/plane/cvt/cvt.hpp"
#include "mesher/torus/walls.hpp"

namespace pcvt::plane {

/// The value of CvtOptions::precondition_below for a run that begins with a coarse start, in which
/// long waves have converged already.
inline constexpr double kPreconditionAfterCoarse = 3e-3;

struct CoarseStartOptions {
    std::uint64_t seed = 0;
    /// At least 1. The result does not depend on it.
    int n_threads = 1;
    /// `nullopt`: rho = 1. With a density, shakes are proportional to the local spacing.
    std::optional<Density> density = {};
    /// The sides of the lattice, upright then, that are walls; the sites lie between them.
    Walls walls = Walls::kNone;
    /// Called once per iteration of the coarser problems, with energies scaled to n sites;
    /// returning false cancels.
    ProgressCallback progress;
};

/// The longest random move of a coordinate between two levels, in units of h of the finer one.
/// Without it, sites stay at their initial positions even where their neighbourhood is a poor one.
inline constexpr double kShake = 0.25;

/// The ratio of h to the distance between neighbours in a hexagonal arrangement.
inline const double kSpacingPerEdge = std::sqrt(std::sqrt(3.0) / 2);

/// The number of sites on each level of a coarse start.
struct LevelSizes {
    /// Of the finest level: those that become four times as many from one level to the next. Sites
    /// without symmetry are orbits of one site.
    int n_orbits = 0;
    int orbit_size = 1;
    /// Other sites, the same on all levels.
    int n_others = 0;

    double n_sites(int orbits) const { return double(orbits) * orbit_size + n_others; }
};

/// The number of orbits on the coarsest level.
int coarsest_level(int n_orbits);

/// Optimises the sites of a level with the options and refines them to n_finer orbits. The seed
/// differs from level to level.
using CoarseLevel = std::function<void(const CvtOptions& options, int n_finer, std::uint64_t seed)>;

/// Runs `level` on all levels but the finest, from coarse to fine.
///
/// Example usage:
///   Points points = uniform_points(lattice, coarsest_level(n), seed);
///   run_coarse_levels({.n_orbits = n}, options,
///                     [&](const CvtOptions& level, int n_finer, std::uint64_t seed) {
///                         points = refined(compute_cvt(lattice, points, level), n_finer, seed);
///                     });
///
/// @returns false if the callback cancelled.
bool run_coarse_levels(const LevelSizes& sizes, const CoarseStartOptions& options,
                       const CoarseLevel& level);

}  // namespace pcvt::plane
