#include "mesher/optimize/newton.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "mesher/optimize/conjugate_gradients.hpp"
#include "mesher/optimize/optimizer_run.hpp"

namespace pcvt {
namespace {

/// Bounds on the relative residual of a step's linear system: at most kLooseSystem and the root of
/// the RMS residual, which makes the convergence superlinear, but not below kBelowTolerance of the
/// residual that the tolerance requires.
constexpr double kLooseSystem = 0.1;
constexpr double kBelowTolerance = 0.3;
/// The first radius over options.max_move.
constexpr double kFirstRadius = 0.2;
/// Thresholds for the actual over the predicted decrease: a step is accepted above kAcceptedRatio;
/// the radius shrinks below kPoorRatio, and grows above kGoodRatio after a truncated step. kShrink
/// and kGrow are the factors.
constexpr double kAcceptedRatio = 0.05;
constexpr double kPoorRatio = 0.25;
constexpr double kGoodRatio = 0.6;
constexpr double kShrink = 0.4;
constexpr double kGrow = 1.5;
/// Values with a smaller relative difference count as equal.
constexpr double kEqualStepValues = 1e-12;
constexpr int kStepTrials = 12;

class Newton {
   public:
    Newton(Objective& objective, const OptimizerOptions& options, Evaluation here,
           int most_truncated, Workers& workers)
        : objective_(objective),
          options_(options),
          most_truncated_(most_truncated),
          run_(objective, options),
          cg_(objective.n_variables(), workers),
          radius_(kFirstRadius * options.max_move),
          here_(std::move(here)) {}

    OptimizerResult minimize();

   private:
    bool advance();
    ConjugateGradients::Outcome solve();
    double accepted_ratio(double t, double slope, double model) const;
    void adapt_radius(const ConjugateGradients::Outcome& system, double t, double ratio);

    Objective& objective_;
    const OptimizerOptions& options_;
    int most_truncated_;
    OptimizerRun run_;
    ConjugateGradients cg_;
    BlockMatrix hessian_;
    Eigen::VectorXf step_;
    double radius_;
    Evaluation here_;
    Evaluation there_;
    int hessians_ = 0;
    int cg_products_ = 0;
    int truncated_in_a_row_ = 0;
};

ConjugateGradients::Outcome Newton::solve() {
    objective_.hessian(hessian_);
    ++hessians_;
    const double superlinear = std::min(kLooseSystem, std::sqrt(here_.rms_residual));
    const double sufficient = kBelowTolerance * options_.tolerance / here_.residual;
    const auto n_variables = static_cast<int>(objective_.n_variables());
    const auto system = cg_.solve(hessian_, here_.gradient,
                                  {std::max(superlinear, sufficient), radius_, 2 * n_variables});
    cg_products_ += system.products;
    step_ = cg_.solution().cast<float>();
    return system;
}

/// The actual over the predicted decrease at t along the step, or 0 if that point is not accepted.
double Newton::accepted_ratio(double t, double slope, double model) const {
    const double change = there_.value - here_.value;
    if (std::abs(change) <= kEqualStepValues * std::abs(here_.value) &&
        there_.rms_residual < here_.rms_residual) {
        return 1;
    }
    const double model_at_t = t * slope + t * t * (model - slope);
    const double ratio = change / model_at_t;
    return model_at_t < 0 && ratio > kAcceptedRatio ? ratio : 0;
}

void Newton::adapt_radius(const ConjugateGradients::Outcome& system, double t, double ratio) {
    const double move = t * system.largest_move;
    if (t < 1) {
        radius_ = move;
    } else if (ratio < kPoorRatio) {
        radius_ = kShrink * move;
    } else if (ratio > kGoodRatio && system.truncated) {
        radius_ = std::min(kGrow * radius_, options_.max_move);
    }
}

/// Takes one step; returns false if no trial step is accepted.
bool Newton::advance() {
    // Minimise the model within the trust region.
    const ConjugateGradients::Outcome system = solve();
    if (!(system.model < 0) || !std::isfinite(system.largest_move)) return false;
    truncated_in_a_row_ = system.truncated ? truncated_in_a_row_ + 1 : 0;
    // Backtrack along the step until a trial is accepted.
    const double slope = here_.gradient.dot(cg_.solution());
    double t = std::min(1.0, options_.max_move / system.largest_move);
    for (int trial = 0; trial < kStepTrials; ++trial, t *= kShrink) {
        if (!run_.evaluate(step_, t, there_)) continue;
        const double ratio = accepted_ratio(t, slope, system.model);
        if (ratio == 0) continue;
        run_.accept();
        std::swap(here_, there_);
        adapt_radius(system, t, ratio);
        return true;
    }
    run_.reject();
    return false;
}

OptimizerResult Newton::minimize() {
    std::optional<Stop> stop;
    while (!stop) {
        stop = run_.before_iteration(here_);
        if (!stop && (truncated_in_a_row_ > most_truncated_ || !advance())) stop = Stop::kStalled;
    }
    OptimizerResult result = run_.finish(*stop, std::move(here_));
    result.run.hessians = hessians_;
    result.run.cg_products = cg_products_;
    return result;
}

}  // namespace

OptimizerResult minimize_newton(Objective& objective, const OptimizerOptions& options,
                                Evaluation here, int most_truncated, Workers& workers) {
    return Newton(objective, options, std::move(here), most_truncated, workers).minimize();
}

}  // namespace pcvt
