#pragma once

#include <Eigen/Core>
#include <functional>

namespace pcvt {

struct BlockMatrix;

/// What an optimiser learns of one point.
struct Evaluation {
    double value = 0;
    Eigen::VectorXd gradient;
    /// M^-1 gradient where the objective has begun to precondition, else empty.
    Eigen::VectorXf preconditioned = {};
    /// What the tolerance is compared with; dimensionless.
    double residual = 0;
    /// The root mean square of what `residual` is the maximum of.
    double rms_residual = 0;
};

/// A function to be minimised, and the point that the optimiser has reached. The point stays with
/// the objective, since it need not lie in a vector space: an optimiser sees only directions and
/// gradients, pairs of variables (x_2i, x_2i+1).
class Objective {
   public:
    virtual ~Objective() = default;

    virtual Eigen::Index n_variables() const = 0;
    /// Evaluates at the point + t direction; t = 0 is the point itself, whatever the direction.
    /// The direction has to stay as it is until this trial is accepted or rejected, or until the
    /// next evaluation.
    /// @returns false where the function is not defined there (two sites coincide).
    virtual bool evaluate(const Eigen::VectorXf& direction, double t, Evaluation& evaluation) = 0;
    /// The point becomes the one that was evaluated last.
    virtual void accept() = 0;
    /// The point stays; whatever has gone to the trial goes back.
    virtual void reject() {}
    /// From now on evaluations carry M^-1 gradient, M a fixed, symmetric, positive definite
    /// approximation of the Hessian near the point; fills it into that of the point too.
    /// @returns false where the objective has none.
    virtual bool precondition(Evaluation&) { return false; }
    /// The fixed-point step at the point evaluated last: the point + it is the next Lloyd iterate.
    virtual void lloyd_step(const Evaluation& evaluation, Eigen::VectorXf& direction) const = 0;
    /// Whether `hessian` tells something.
    virtual bool has_hessian() const { return false; }
    /// The second derivatives at the point, which must be what was evaluated last.
    virtual void hessian(BlockMatrix& /*hessian*/) const {}
};

enum class Stop { kConverged, kIterationLimit, kStalled, kCancelled };

/// One line of a run's history.
struct Progress {
    int iteration = 0;
    int evaluations = 0;
    double value = 0;
    double residual = 0;
    double rms_residual = 0;
    /// Above 0 in a search through many starts: the evaluations that it may spend. `iteration` then
    /// counts the starts, and `value` is the lowest so far.
    int budget = 0;
};

/// Called once an iteration, on the calling thread; false cancels.
using ProgressCallback = std::function<bool(const Progress&)>;
/// Asked once an iteration.
using ProgressTest = std::function<bool(const Progress&)>;

struct OptimizerOptions {
    /// Stops once the residual is at most this.
    double tolerance = 1e-6;
    /// Negative: no limit.
    int max_iterations = -1;
    /// No variable pair (x_2i, x_2i+1) moves further than this in one step; length units.
    double max_move = 0;
    ProgressCallback progress = {};
    /// Stops as converged also where this says so.
    ProgressTest stop_when = {};
    /// The root mean square residual below which the objective is asked to precondition.
    double precondition_below = 0;
};

/// Where an optimiser ended and why; the objective is at the point itself.
struct OptimizerResult {
    Stop stop = Stop::kStalled;
    int iterations = 0;
    int evaluations = 0;
    Evaluation evaluation;
    /// Of Newton's method, not counted among the evaluations: Hessians, and products with them.
    int hessians = 0;
    int cg_products = 0;
};

}  // namespace pcvt
