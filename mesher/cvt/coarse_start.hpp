#pragma once

#include <cstdint>
#include <optional>

#include "mesher/cvt/cvt.hpp"

namespace pcvt {

/// For CvtOptions::precondition_below after a coarse start, which has settled the long waves.
inline constexpr double kPreconditionAfterCoarse = 3e-3;

struct CoarseStartOptions {
    std::uint64_t seed = 0;
    /// At least 1. The result does not depend on it.
    int n_threads = 1;
    /// Nothing: rho = 1. With one, distances go with the local spacing.
    std::optional<Density> density = {};
    /// Called once an iteration of the coarser problems, with values as they would be for n sites;
    /// false cancels.
    ProgressCallback progress;
};

/// Sites for an optimisation to begin with, from coarse to fine.
///
/// Begins with a sixteenth of the sites, at random, optimises them, adds the midpoints of the
/// Delaunay edges, which makes four times as many, shakes all of them, and so on until there are n.
/// Long waves are settled while there are few sites: the optimisation that follows needs fewer
/// iterations and ends in a lower minimum, with fewer cells that are no hexagons, than one from
/// random sites. These minima are others than those that random sites lead to. With a density this
/// holds where the coarsest cells resolve it; where it jumps, or a picture has finer detail, the
/// minimum is a higher one (by 3 % for a checkerboard of contrast 1:100 and 10,000 sites).
///
/// @returns 2 x n, length units; without columns where the callback cancelled.
Points coarse_start(const Lattice& lattice, int n, const CoarseStartOptions& options);

}  // namespace pcvt
