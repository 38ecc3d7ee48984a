#pragma once

#include "mesher/optimize/objective.hpp"

namespace pcvt {

/// Fills a direction along which the value falls, from the evaluation of the point, which was
/// evaluated last.
using DescentStep = std::function<bool(const Evaluation& here, Eigen::VectorXf& direction)>;

/// L-BFGS for convex functions whose evaluations cost much more than some vectors: with
/// kConvexPairs pairs in double precision. Steps are chosen by the slopes along a line, which grow
/// along it, so that values, whose differences are lost in rounding near the minimum, are not used.
///
/// Example usage:
///
///     const OptimizerResult result = minimize_convex(objective, scales, {.max_move = 0.5 * h});
///
/// @param scales  the inverse of a diagonal that is near to the Hessian: of each variable.
/// @param step    takes the place of the direction of L-BFGS where it returns true.
OptimizerResult minimize_convex(Objective& objective, const Eigen::VectorXd& scales,
                                const OptimizerOptions& options, const DescentStep& step = {});

inline constexpr int kConvexPairs = 40;

}  // namespace pcvt
