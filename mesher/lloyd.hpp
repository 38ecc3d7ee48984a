#pragma once

#include "mesher/objective.hpp"

namespace pcvt {

/// Lloyd's fixed-point iteration x <- x + lloyd_step (S. Lloyd 1982), the baseline.
///
/// Steps are clamped to options.max_move; stalled once 200 iterations brought no lower value and no
/// smaller residual.
OptimizerResult minimize_lloyd(const Objective& objective, const Eigen::VectorXd& start,
                               const OptimizerOptions& options);

}  // namespace pcvt
