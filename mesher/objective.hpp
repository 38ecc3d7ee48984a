#pragma once

#include <Eigen/Core>
#include <functional>

namespace pcvt {

/// What an optimiser learns of one point x.
struct Evaluation {
    double value = 0;
    Eigen::VectorXd gradient;
    /// The fixed-point step: x + lloyd_step is the next Lloyd iterate.
    Eigen::VectorXd lloyd_step;
    /// What the tolerance is compared with; dimensionless.
    double residual = 0;
    /// The root mean square of what `residual` is the maximum of.
    double rms_residual = 0;
};

/// A function to be minimised. Returns false where it is not defined at x (two sites coincide): the
/// step is then rejected and tried shorter.
using Objective = std::function<bool(const Eigen::VectorXd& x, Evaluation& evaluation)>;

enum class Stop { kConverged, kIterationLimit, kStalled, kCancelled };

/// One line of a run's history.
struct Progress {
    int iteration = 0;
    int evaluations = 0;
    double value = 0;
    double residual = 0;
    double rms_residual = 0;
};

/// Called once an iteration, on the calling thread; false cancels.
using ProgressCallback = std::function<bool(const Progress&)>;

struct OptimizerOptions {
    /// Stops once the residual is at most this.
    double tolerance = 1e-6;
    /// Negative: no limit.
    int max_iterations = -1;
    /// No variable pair (x_2i, x_2i+1) moves further than this in one step; length units.
    double max_move = 0;
    ProgressCallback progress;
};

/// Where an optimiser ended and why.
struct OptimizerResult {
    Stop stop = Stop::kStalled;
    int iterations = 0;
    int evaluations = 0;
    Eigen::VectorXd x;
    Evaluation evaluation;
};

}  // namespace pcvt
