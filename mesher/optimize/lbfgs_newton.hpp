#pragma once

#include "mesher/base/workers.hpp"
#include "mesher/optimize/objective.hpp"

namespace pcvt {

/// When Newton's method may begin: where the RMS residual shows that a minimum is near, with or
/// without bounds on the number of variables, or at the first point.
enum class NewtonStart { kNear, kNearForAnyNumber, kAtOnce };

/// Alternates between L-BFGS (lbfgs.hpp) and Newton's method (newton.hpp).
///
/// With `kNear` Newton's method begins at an RMS residual of 1e-4 if there are at most 15,000 pairs
/// of variables; for any number of variables it begins at the first point if the RMS residual there
/// is at most 0.1, because the sites then lie near a lattice. `kNearForAnyNumber` uses the
/// threshold 1e-4 everywhere, without these two bounds. Where Newton's method gets stuck, or (not
/// with `kAtOnce`) ends at its trust region too often, L-BFGS continues until the RMS residual has
/// fallen to a third, and so on; each such leg evaluates its first point once more. Iterations and
/// evaluations are counted over all legs. The run ends as `stalled` where L-BFGS does. For an
/// objective without a Hessian, L-BFGS runs to the end.
///
/// Example usage:
///
///     Workers workers(n_threads);
///     const OptimizerResult result = minimize_lbfgs_newton(
///         objective, {.tolerance = 1e-9, .max_move = 0.5 * h}, NewtonStart::kNear, workers);
OptimizerResult minimize_lbfgs_newton(Objective& objective, const OptimizerOptions& options,
                                      NewtonStart start, Workers& workers);

}  // namespace pcvt
