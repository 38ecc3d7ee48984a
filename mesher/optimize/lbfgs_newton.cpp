#include "mesher/optimize/lbfgs_newton.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "mesher/optimize/lbfgs.hpp"
#include "mesher/optimize/newton.hpp"

namespace pcvt {
namespace {

/// The RMS residual at which Newton's method takes over from L-BFGS, and the largest number of
/// sites for which it does. With more sites L-BFGS with the long-wave preconditioner reaches the
/// minimum much faster: already at n = 10^4 Newton's method needs half as many evaluations but 1.4
/// times the time.
constexpr double kNear = 1e-4;
constexpr Eigen::Index kMostAfterLbfgs = 15'000;
/// The same threshold at the first point: sites of a lattice with noise 0.1 h start at 0.074,
/// uniform random sites at 0.3.
constexpr double kNearAtFirst = 0.1;
/// The factor by which L-BFGS must reduce the RMS residual before Newton's method, once stuck,
/// begins again.
constexpr double kGain = 1.0 / 3;
/// After this number of truncated steps in a row L-BFGS reaches the minimum in less time.
constexpr int kMostTruncated = 4;

class LbfgsNewton {
   public:
    LbfgsNewton(Objective& objective, const OptimizerOptions& options, Workers& workers)
        : objective_(objective), options_(options), workers_(workers) {}

    /// Runs one leg; returns whether the whole run has ended other than by a stall.
    bool lbfgs(const ProgressTest& stop_when);
    bool newton(int most_truncated);

    bool stalled() const { return result_.run.stop == Stop::kStalled; }
    double rms_residual() const { return result_.run.rms_residual; }
    OptimizerResult take() { return std::move(result_); }

   private:
    OptimizerOptions leg_options() const;
    bool add(OptimizerResult leg);

    Objective& objective_;
    const OptimizerOptions& options_;
    Workers& workers_;
    OptimizerResult result_;
};

/// Options for the next leg: counts continue from the previous legs, and the iteration that ended
/// the last leg is not reported twice.
OptimizerOptions LbfgsNewton::leg_options() const {
    OptimizerOptions leg = options_;
    const int iterations = result_.run.iterations;
    const int evaluations = result_.run.evaluations;
    if (leg.max_iterations >= 0) leg.max_iterations -= iterations;
    if (options_.progress && evaluations > 0) {
        leg.progress = [this, iterations, evaluations](Progress progress) {
            if (progress.iteration == 0) return true;
            progress.iteration += iterations;
            progress.evaluations += evaluations;
            return options_.progress(progress);
        };
    }
    return leg;
}

bool LbfgsNewton::add(OptimizerResult leg) {
    leg.run.add_counts(result_.run);
    result_ = std::move(leg);
    if (result_.run.stop == Stop::kConverged) return result_.run.residual <= options_.tolerance;
    return !stalled();
}

bool LbfgsNewton::lbfgs(const ProgressTest& stop_when) {
    OptimizerOptions leg = leg_options();
    leg.stop_when = stop_when;
    return add(minimize_lbfgs(objective_, leg, workers_));
}

bool LbfgsNewton::newton(int most_truncated) {
    const OptimizerOptions leg = leg_options();
    return add(
        minimize_newton(objective_, leg, std::move(result_.evaluation), most_truncated, workers_));
}

}  // namespace

OptimizerResult minimize_lbfgs_newton(Objective& objective, const OptimizerOptions& options,
                                      NewtonStart start, Workers& workers) {
    if (!objective.has_hessian()) return minimize_lbfgs(objective, options, workers);
    // Choose the thresholds at which Newton's method begins.
    LbfgsNewton run(objective, options, workers);
    const bool at_once = start == NewtonStart::kAtOnce;
    const int most_truncated = at_once ? std::numeric_limits<int>::max() : kMostTruncated;
    const bool for_any_number = start == NewtonStart::kNearForAnyNumber;
    const bool few = objective.n_variables() <= 2 * kMostAfterLbfgs;
    const double near = few || for_any_number ? kNear : 0;
    const double near_at_first = for_any_number ? near : kNearAtFirst;
    ProgressTest stop_when = [=](const Progress& p) {
        return at_once || p.rms_residual <= (p.iteration == 0 ? near_at_first : near);
    };
    // Alternate until a leg ends the run or L-BFGS stalls.
    while (!run.lbfgs(stop_when) && !run.stalled() && !run.newton(most_truncated)) {
        const double target = std::min(near, kGain * run.rms_residual());
        stop_when = [target](const Progress& p) { return p.rms_residual < target; };
    }
    return run.take();
}

}  // namespace pcvt
