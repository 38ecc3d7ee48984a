#pragma once

#include "mesher/base/workers.hpp"
#include "mesher/optimize/objective.hpp"

namespace pcvt {

/// Limited-memory BFGS with 5 pairs, stored at 16 bits a number (J. Nocedal 1980; for CVT: Y. Liu
/// et al. 2009).
///
/// The first step, and each step after a reset of the history, is the Lloyd step. No step moves a
/// pair of variables further than options.max_move; weak curvature along a step resets the history.
/// The line search satisfies the weak Wolfe conditions, or the approximate ones of Hager and Zhang
/// (2005) where the value no longer resolves the decrease. The run ends as `stalled` where no step
/// along the Lloyd direction is accepted, or after 200 iterations without a lower value or a
/// smaller residual.
///
/// Example usage:
///
///     const OptimizerResult result =
///         minimize_lbfgs(objective, {.tolerance = 1e-6, .max_move = 0.5 * h}, workers);
OptimizerResult minimize_lbfgs(Objective& objective, const OptimizerOptions& options,
                               Workers& workers);

}  // namespace pcvt
