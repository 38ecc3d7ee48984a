#include "mesher/optimize/lbfgs.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "mesher/optimize/lbfgs_history.hpp"
#include "mesher/optimize/optimizer_run.hpp"

namespace pcvt {
namespace {

/// The weak Wolfe conditions: F(t) <= F(0) + c1 t F'(0) and F'(t) >= c2 F'(0).
constexpr double kDecrease = 1e-4;
constexpr double kCurvature = 0.9;
/// Values with a smaller relative difference count as equal (approximate Wolfe conditions).
constexpr double kEqualLineValues = 1e-12;
constexpr int kLineTrials = 25;

/// A trial step t along a line, with F(t) and F'(t).
struct LinePoint {
    double t;
    double value;
    double slope;
};

enum class Verdict { kAccept, kTooLong, kTooShort };

Verdict judge(const LinePoint& start, const LinePoint& trial) {
    const bool decrease = trial.value <= start.value + kDecrease * trial.t * start.slope;
    const bool curvature = trial.slope >= kCurvature * start.slope;
    if (decrease) return curvature ? Verdict::kAccept : Verdict::kTooShort;
    const bool equal =
        std::abs(trial.value - start.value) <= kEqualLineValues * std::abs(start.value);
    const bool approximate = trial.slope <= (2 * kDecrease - 1) * start.slope;
    if (equal && approximate) return curvature ? Verdict::kAccept : Verdict::kTooShort;
    return Verdict::kTooLong;
}

/// The minimiser of the parabola through the values at both ends with the given slope at `low`,
/// bounded away from the ends.
double interpolate(const LinePoint& low, const LinePoint& high) {
    const double width = high.t - low.t;
    const double curvature = (high.value - low.value) / width - low.slope;
    double fraction = 0.5;
    if (curvature > 0) fraction = -0.5 * low.slope / curvature;
    return low.t + std::clamp(fraction, 0.1, 0.9) * width;
}

/// The line search: tries steps t with 0 < t <= longest along the history's direction. Returns an
/// acceptable t, with the evaluation at that point, or nullopt if no trial step is acceptable.
std::optional<double> search_line(OptimizerRun& run, LbfgsHistory& history, double slope,
                                  double longest, Evaluation& evaluation) {
    const LinePoint start{0, evaluation.value, slope};
    LinePoint low = start;
    std::optional<LinePoint> high;
    double t = std::min(1.0, longest);
    for (int trial = 0; trial < kLineTrials; ++trial) {
        if (!run.evaluate(history.direction(), t, evaluation)) {
            high = LinePoint{t, std::numeric_limits<double>::infinity(), 0};
        } else {
            const LinePoint point{t, evaluation.value, history.directional_derivative(evaluation)};
            const Verdict verdict = judge(start, point);
            if (verdict == Verdict::kAccept) return t;
            if (verdict == Verdict::kTooShort && t >= longest) return t;
            if (verdict == Verdict::kTooShort) low = point;
            if (verdict == Verdict::kTooLong) high = point;
        }
        t = high ? interpolate(low, *high) : std::min(3 * t, longest);
    }
    return std::nullopt;
}

/// The first direction: the preconditioner's approximation of the Newton step, or without a
/// preconditioner the Lloyd step.
void begin_direction(const Objective& objective, const Evaluation& here,
                     Eigen::VectorXf& direction) {
    if (here.preconditioned.size() > 0) {
        direction = -here.preconditioned;
    } else {
        objective.lloyd_step(here, direction);
    }
}

/// Takes one step; where the line search fails, resets the history and tries the first direction.
/// The evaluation belongs to the current point, before and after.
bool advance(OptimizerRun& run, Objective& objective, const OptimizerOptions& options,
             LbfgsHistory& history, Evaluation& evaluation) {
    for (;;) {
        const bool fresh = history.empty();
        if (fresh) begin_direction(objective, evaluation, history.direction());
        const auto [slope, largest_move] = history.compute_direction();
        const double longest = options.max_move / largest_move;
        if (slope < 0) {
            if (const auto t = search_line(run, history, slope, longest, evaluation)) {
                history.append_pair(*t);
                run.accept();
                return true;
            }
        }
        // Restores the current point, because `lloyd_step` also requires that it was evaluated
        // last.
        if (!run.evaluate(history.direction(), 0, evaluation) || fresh) return false;
        history.begin(evaluation);
    }
}

}  // namespace

OptimizerResult minimize_lbfgs(Objective& objective, const OptimizerOptions& options,
                               Workers& workers) {
    OptimizerRun run(objective, options);
    LbfgsHistory history(objective.n_variables(), workers);
    Evaluation here;
    if (!run.evaluate(history.direction(), 0, here)) return run.finish(Stop::kStalled, here);
    history.begin(here);
    bool may_precondition = true;
    for (;;) {
        if (const auto stop = run.before_iteration(here)) return run.finish(*stop, here);
        if (may_precondition && here.rms_residual < options.precondition_below) {
            if (objective.precondition(here)) history.begin(here);
            may_precondition = false;
        }
        if (objective.relax_parts(here, options.tolerance)) {
            if (!run.evaluate(history.direction(), 0, here)) {
                return run.finish(Stop::kStalled, here);
            }
            history.begin(here);
            continue;
        }
        if (!advance(run, objective, options, history, here)) {
            return run.finish(Stop::kStalled, here);
        }
    }
}

}  // namespace pcvt
