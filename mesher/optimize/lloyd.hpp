#pragma once

#include "mesher/optimize/objective.hpp"

namespace pcvt {

/// Lloyd's fixed-point iteration (S. Lloyd 1982), the baseline: repeats the Lloyd step.
///
/// Steps are clamped to options.max_move. The run ends as `stalled` after 200 iterations without a
/// lower value or a smaller residual.
///
/// Example usage:
///
///     const OptimizerResult result =
///         minimize_lloyd(objective, {.max_iterations = 100, .max_move = 0.5 * h});
OptimizerResult minimize_lloyd(Objective& objective, const OptimizerOptions& options);

}  // namespace pcvt
