#pragma once

#include "mesher/base/workers.hpp"
#include "mesher/optimize/objective.hpp"

namespace pcvt {

/// Newton's method in a trust region. Its steps minimise the quadratic model by truncated conjugate
/// gradients on the exact Hessian (T. Steihaug 1983; R. Dembo, S. Eisenstat, T. Steihaug 1982);
/// convergence near a minimum is superlinear.
///
/// The trust region bounds the move of each pair of variables. Its radius, at most
/// options.max_move, follows the ratio of the actual to the predicted decrease. A step is accepted
/// where it lowers the value, or where the value no longer resolves the decrease and the RMS
/// residual falls; a step that is not accepted is shortened along the same line. Directions of
/// negative curvature are followed to the boundary, so that the method ends in minima and not in
/// saddle points.
///
/// The run ends as `stalled` where no step is accepted, after 200 iterations without a gain, or
/// after more than `most_truncated` steps in a row that ended at the boundary: far from a minimum
/// L-BFGS makes the same progress at a lower cost.
///
/// @param here  the evaluation of the current point, which must have been evaluated last.
OptimizerResult minimize_newton(Objective& objective, const OptimizerOptions& options,
                                Evaluation here, int most_truncated, Workers& workers);

}  // namespace pcvt
