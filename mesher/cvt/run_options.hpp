#pragma once

#include "mesher/cvt/solvers.hpp"

namespace pcvt {

/// The solver of a run that moves sites to a minimum, its ends, its threads and its callback: the
/// same in the plane and in space.
///
/// Example usage:
///
///     CvtOptions options;
///     options.run = {.tolerance = 1e-9, .n_threads = 4};
///     const CvtResult result = compute_cvt(lattice, points, options);
struct RunOptions {
    Solver solver = Solver::kLbfgs;
    /// The run has converged once every |x_i - g_i| / h is at most this, h = sqrt(area / n), in
    /// space the cube root of volume / n.
    double tolerance = 1e-6;
    /// Negative: no limit. 0: the result is the periodic Voronoi diagram of the given sites.
    int max_iterations = -1;
    /// At least 1. The result does not depend on it.
    int n_threads = 1;
    ProgressCallback progress = {};
};

}  // namespace pcvt
