#pragma once

#include <optional>

#include "mesher/optimize/optimizer_run.hpp"

namespace pcvt {

/// L-BFGS for convex functions whose evaluations cost much more than some vectors: with
/// kConvexPairs pairs in double precision. Steps are chosen by the slopes along a line, which grow
/// along it, so that values, whose differences are lost in rounding near the minimum, are not used.
///
/// Example usage:
///
///     const OptimizerResult result = minimize_convex(objective, scales, {.max_move = 0.5 * h});
///
/// @param scales  the inverse of a diagonal that is near to the Hessian: of each variable.
OptimizerResult minimize_convex(Objective& objective, const Eigen::VectorXd& scales,
                                const OptimizerOptions& options);

/// Finds a step t <= `longest` along a direction of descent at which the slope is neither steep nor
/// rises as steeply as it fell at the beginning.
/// @param evaluation  of the present point; then of the step.
/// @returns nullopt if there is none; `evaluation` is that of the last trial then.
std::optional<double> search_slopes(OptimizerRun& run, const Eigen::VectorXf& direction,
                                    double longest, Evaluation& evaluation);

inline constexpr int kConvexPairs = 40;

}  // namespace pcvt
