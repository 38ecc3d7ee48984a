#pragma once

#include "mesher/optimize/objective.hpp"

namespace pcvt {

/// Lloyd's fixed-point iteration (S. Lloyd 1982), the baseline: the Lloyd step again and again.
///
/// Steps are clamped to options.max_move; stalled once 200 iterations brought no lower value and no
/// smaller residual.
OptimizerResult minimize_lloyd(Objective& objective, const OptimizerOptions& options);

}  // namespace pcvt
