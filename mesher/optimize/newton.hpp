#pragma once

#include "mesher/base/workers.hpp"
#include "mesher/optimize/objective.hpp"

namespace pcvt {

/// Newton's method in a trust region, its steps by truncated conjugate gradients on the exact
/// Hessian (T. Steihaug 1983; R. Dembo, S. Eisenstat, T. Steihaug 1982), superlinear near a
/// minimum.
///
/// The trust region bounds the move of each pair of variables; its radius, at most
/// options.max_move, follows the ratio of the decrease to that of the quadratic model. A step is
/// accepted where it lowers the value, or where the value no longer resolves the decrease and the
/// RMS residual falls; a longer one is tried shorter along the same line. Negative curvature is
/// followed to the boundary, so that it ends in minima, not in saddles.
///
/// It ends `stalled` where no step is accepted, after 200 iterations that brought no gain, or after
/// `most_truncated` steps in a row that ended at the boundary: far from a minimum L-BFGS does as
/// well for less.
///
/// @param here  of the point, which must be what was evaluated last.
OptimizerResult minimize_newton(Objective& objective, const OptimizerOptions& options,
                                Evaluation here, int most_truncated, Workers& workers);

}  // namespace pcvt
