#pragma once

#include <Eigen/Core>
#include <functional>

#include "mesher/optimize/run_statistics.hpp"

namespace pcvt {

struct BlockMatrix;

/// The value, the gradient and the residuals at one point.
struct Evaluation {
    double value = 0;
    Eigen::VectorXd gradient;
    /// M^-1 gradient once the objective preconditions, else empty.
    Eigen::VectorXf preconditioned = {};
    /// The convergence measure that is compared with the tolerance; dimensionless.
    double residual = 0;
    /// The root mean square of the same quantities whose maximum is `residual`.
    double rms_residual = 0;
};

/// A function to be minimised, together with the current point. The objective owns the point, since
/// it need not lie in a vector space: an optimiser sees only directions and gradients, as pairs of
/// variables (x_2i, x_2i+1).
///
/// Example usage (F = sum of x_k^2; the objective keeps the trial point until it is accepted):
///
///     bool Bowl::evaluate(const Eigen::VectorXf& d, double t, Evaluation& e) {
///         trial_ = x_;
///         if (t != 0) trial_ += t * d.cast<double>();
///         e.value = trial_.squaredNorm();
///         e.gradient = 2 * trial_;
///         e.residual = e.rms_residual = e.gradient.norm();
///         return true;
///     }
///     void Bowl::accept() { x_ = trial_; }
class Objective {
   public:
    virtual ~Objective() = default;

    virtual Eigen::Index n_variables() const = 0;
    /// Evaluates at point + t * direction; t = 0 is the point itself, for any direction. The
    /// direction must not change until this trial is accepted or rejected, or until the next
    /// evaluation.
    /// @returns false where the function is not defined (two sites coincide).
    virtual bool evaluate(const Eigen::VectorXf& direction, double t, Evaluation& evaluation) = 0;
    /// Moves the point to the trial point that was evaluated last.
    virtual void accept() = 0;
    /// Keeps the point and undoes the trial.
    virtual void reject() {}
    /// Makes all later evaluations carry M^-1 gradient, with M a fixed, symmetric, positive
    /// definite approximation of the Hessian near the point. Fills it into the given evaluation of
    /// the point too.
    /// @returns false if the objective has no preconditioner.
    virtual bool precondition(Evaluation&) { return false; }
    /// Moves the point to one where the value is not higher, by minimising over few variables, if
    /// that costs less than iterations with all variables. The optimiser calls it before each
    /// iteration.
    /// @param tolerance  the largest residual at which the optimiser ends.
    /// @returns whether the point has moved; it must then be evaluated.
    virtual bool relax_parts(const Evaluation& /*here*/, double /*tolerance*/) { return false; }
    /// The fixed-point step at the point evaluated last: point + direction is the next Lloyd
    /// iterate.
    virtual void lloyd_step(const Evaluation& evaluation, Eigen::VectorXf& direction) const = 0;
    /// Whether `hessian` computes the second derivatives.
    virtual bool has_hessian() const { return false; }
    /// The second derivatives at the point, which must have been evaluated last.
    virtual void hessian(BlockMatrix& /*hessian*/) const {}
};

/// One iteration in the history of a run.
struct Progress {
    int iteration = 0;
    int evaluations = 0;
    double value = 0;
    double residual = 0;
    double rms_residual = 0;
    /// Above 0 in a search over many starts: the number of evaluations that the search may use.
    /// `iteration` then counts the starts, and `value` is the lowest value so far.
    int budget = 0;
    /// In a coarse start, the part of its work that is done, from 0 to 1.
    double share = 0;
    /// Returns the positions of the sites at this iteration, 2 x n, in the order of the result and
    /// in length units. Valid during the callback; nullptr where positions are not known.
    const std::function<Eigen::Matrix2Xd()>* positions = nullptr;
};

/// Called once per iteration on the calling thread; returning false cancels the run.
using ProgressCallback = std::function<bool(const Progress&)>;
/// Evaluated once per iteration.
using ProgressTest = std::function<bool(const Progress&)>;

struct OptimizerOptions {
    /// The run converges once the residual is at most this.
    double tolerance = 1e-6;
    /// Negative: no limit.
    int max_iterations = -1;
    /// No variable pair (x_2i, x_2i+1) moves further than this in one step; length units.
    double max_move = 0;
    ProgressCallback progress = {};
    /// The run also ends as converged where this returns true.
    ProgressTest stop_when = {};
    /// The RMS residual below which the optimiser calls Objective::precondition.
    double precondition_below = 0;
};

/// How and why a run ended; the objective holds the point itself.
struct OptimizerResult {
    RunStatistics run;
    Evaluation evaluation;
};

}  // namespace pcvt
