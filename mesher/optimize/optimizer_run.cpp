#include "mesher/optimize/optimizer_run.hpp"

#include <cmath>

namespace pcvt {
namespace {

/// The relative decrease of the value, and the factor on the residual, that count as a gain;
/// smaller changes are rounding.
constexpr double kValueGain = 1e-14;
constexpr double kResidualGain = 0.99;
constexpr int kIterationsWithoutGain = 200;

}  // namespace

OptimizerRun::OptimizerRun(Objective& objective, const OptimizerOptions& options)
    : objective_(objective), options_(options) {}

bool OptimizerRun::evaluate(const Eigen::VectorXf& direction, double t, Evaluation& evaluation) {
    ++evaluations_;
    return objective_.evaluate(direction, t, evaluation) && std::isfinite(evaluation.value);
}

std::optional<Stop> OptimizerRun::before_iteration(const Evaluation& evaluation) {
    ++iterations_;
    const Progress progress{.iteration = iterations_,
                            .evaluations = evaluations_,
                            .value = evaluation.value,
                            .residual = evaluation.residual,
                            .rms_residual = evaluation.rms_residual};
    if (options_.progress && !options_.progress(progress)) return Stop::kCancelled;
    if (evaluation.residual <= options_.tolerance) return Stop::kConverged;
    if (options_.max_iterations >= 0 && iterations_ >= options_.max_iterations) {
        return Stop::kIterationLimit;
    }
    if (options_.stop_when && options_.stop_when(progress)) return Stop::kConverged;
    if (stalled(evaluation)) return Stop::kStalled;
    return std::nullopt;
}

OptimizerResult OptimizerRun::finish(Stop stop, Evaluation evaluation) const {
    const RunStatistics run{.stop = stop,
                            .iterations = iterations_,
                            .evaluations = evaluations_,
                            .energy = evaluation.value,
                            .residual = evaluation.residual,
                            .rms_residual = evaluation.rms_residual};
    return {run, std::move(evaluation)};
}

bool OptimizerRun::stalled(const Evaluation& evaluation) {
    const bool lower = evaluation.value < best_value_ - kValueGain * std::abs(best_value_);
    const bool smaller = evaluation.residual < kResidualGain * best_residual_;
    if (lower || smaller || iterations_ == 0) {
        last_gain_ = iterations_;
        best_value_ = std::min(best_value_, evaluation.value);
        best_residual_ = std::min(best_residual_, evaluation.residual);
    }
    return iterations_ - last_gain_ >= kIterationsWithoutGain;
}

double largest_move(const Eigen::VectorXf& step) {
    const Eigen::Map<const Eigen::Matrix2Xf> moves(step.data(), 2, step.size() / 2);
    return std::sqrt(double(moves.colwise().squaredNorm().maxCoeff()));
}

}  // namespace pcvt
