#pragma once

#include <limits>
#include <optional>

#include "mesher/optimize/objective.hpp"

namespace pcvt {

/// The bookkeeping that all optimisers share: counts evaluations, reports progress and decides when
/// to stop.
class OptimizerRun {
   public:
    OptimizerRun(Objective& objective, const OptimizerOptions& options);

    /// Evaluates the objective and counts the evaluation.
    bool evaluate(const Eigen::VectorXf& direction, double t, Evaluation& evaluation);
    void accept() { objective_.accept(); }
    void reject() { objective_.reject(); }
    /// Must be called before each iteration; reports progress and returns the reason to stop, if
    /// any.
    std::optional<Stop> before_iteration(const Evaluation& evaluation);
    OptimizerResult finish(Stop stop, Evaluation evaluation) const;

   private:
    bool stalled(const Evaluation& evaluation);

    Objective& objective_;
    const OptimizerOptions& options_;
    int iterations_ = -1;
    int evaluations_ = 0;
    double best_value_ = std::numeric_limits<double>::infinity();
    double best_residual_ = std::numeric_limits<double>::infinity();
    int last_gain_ = 0;
};

/// The largest |(step_2i, step_2i+1)|.
double largest_move(const Eigen::VectorXf& step);

}  // namespace pcvt
