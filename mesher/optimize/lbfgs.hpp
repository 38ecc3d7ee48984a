#pragma once

#include "mesher/base/workers.hpp"
#include "mesher/optimize/objective.hpp"

namespace pcvt {

/// Limited-memory BFGS with 5 pairs at 16 bits a number (J. Nocedal 1980; for CVT: Y. Liu et al.
/// 2009).
///
/// The first step, and each step after a reset of the history, is the Lloyd step. A step never
/// moves a pair of variables further than options.max_move; weak curvature resets the history. The
/// line search satisfies the weak Wolfe conditions, or the approximate ones of Hager and Zhang
/// (2005) where the value no longer resolves the decrease. It ends `stalled` where no step along
/// the Lloyd direction is accepted, or 200 iterations brought no lower value and no smaller
/// residual.
OptimizerResult minimize_lbfgs(Objective& objective, const OptimizerOptions& options,
                               Workers& workers);

}  // namespace pcvt
