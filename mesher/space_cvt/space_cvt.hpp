#pragma once

#include "mesher/optimize/objective.hpp"
#include "mesher/space/space_delaunay.hpp"

namespace pcvt {

enum class SpaceSolver { kLbfgs, kLloyd };

struct SpaceCvtOptions {
    SpaceSolver solver = SpaceSolver::kLbfgs;
    /// The run has converged once every |x_i - g_i| / h is at most this, h the cube root of
    /// volume / n.
    double tolerance = 1e-6;
    /// Negative: no limit. 0: the result is the periodic Voronoi diagram of the given sites.
    int max_iterations = -1;
    /// At least 1. The result does not depend on it.
    int n_threads = 1;
    ProgressCallback progress = {};
};

/// A periodic tessellation of space and the figures of the run that computed it.
struct SpaceCvtResult {
    SpaceDelaunay delaunay;
    /// The energy is F, length^5.
    RunStatistics run;
    /// Builds of the triangulation after the first one.
    int n_rebuilds = 0;
};

/// Moves the sites to a periodic CVT in space.
///
/// Example usage:
///   const SpaceLattice cube = SpaceLattice::box(1, 1, 1);
///   const SpaceCvtResult result = compute_space_cvt(cube, uniform_points(cube, 1000, 1), {});
///
/// @param points  3 x n, length units; need not be wrapped.
/// @throws InvalidInput as SpaceSites does, and DuplicateSites with all sites that are nearer than
///         1e-9 h to an earlier one.
SpaceCvtResult compute_space_cvt(const SpaceLattice& lattice, const Points3& points,
                                 const SpaceCvtOptions& options);

/// The energy of n cells of the body-centred cubic lattice, truncated octahedra, of the same total
/// volume: no periodic tessellation with less energy is known.
double body_centred_energy(double volume, int n_sites);

}  // namespace pcvt
