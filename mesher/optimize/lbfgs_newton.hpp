#pragma once

#include "mesher/base/workers.hpp"
#include "mesher/optimize/objective.hpp"

namespace pcvt {

/// When Newton's method may begin: where the RMS residual shows that a minimum is near, the same
/// for any number of variables, or at once.
enum class NewtonStart { kNear, kNearForAnyNumber, kAtOnce };

/// L-BFGS (lbfgs.hpp) and Newton's method (newton.hpp) in turn.
///
/// With `kNear` Newton begins at an RMS residual of 1e-4 if there are at most 15,000 pairs of
/// variables, or for any number at the very first point if it is at most 0.1 there: then the sites
/// stand near a lattice. `kNearForAnyNumber` knows neither of these two bounds. Where it gets
/// stuck, or from `kNear` on is often stopped by its trust region, L-BFGS takes over until the RMS
/// residual has fallen to a third, and so on; it then evaluates its first point once more.
/// Iterations and evaluations are those of all legs. It ends `stalled` where L-BFGS does. Of an
/// objective without a Hessian all is left to L-BFGS.
OptimizerResult minimize_lbfgs_newton(Objective& objective, const OptimizerOptions& options,
                                      NewtonStart start, Workers& workers);

}  // namespace pcvt
