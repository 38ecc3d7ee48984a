#include "mesher/optimize/convex_lbfgs.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <optional>
#include <vector>

#include "mesher/optimize/optimizer_run.hpp"

namespace pcvt {
namespace {

/// A step is accepted where the slope lies between these parts of that at its beginning, which is
/// negative.
constexpr double kSteepest = 0.9;
constexpr double kRising = -0.5;
constexpr int kSlopeTrials = 25;

struct StepPair {
    Eigen::VectorXd step;
    Eigen::VectorXd change;
    /// 1 / step.change
    double inverse;
};

/// The product of the inverse Hessian by the pairs with a gradient, negative (J. Nocedal 1980).
Eigen::VectorXd descent(const std::deque<StepPair>& pairs, const Eigen::VectorXd& scales,
                        const Eigen::VectorXd& gradient) {
    Eigen::VectorXd direction = -gradient;
    std::vector<double> parts(pairs.size());
    for (std::size_t k = pairs.size(); k-- > 0;) {
        parts[k] = pairs[k].inverse * pairs[k].step.dot(direction);
        direction -= parts[k] * pairs[k].change;
    }
    direction.array() *= scales.array();
    if (!pairs.empty()) {
        const Eigen::VectorXd& change = pairs.back().change;
        direction /=
            pairs.back().inverse * change.dot(Eigen::VectorXd(scales.cwiseProduct(change)));
    }
    for (std::size_t k = 0; k < pairs.size(); ++k) {
        const double part = pairs[k].inverse * pairs[k].change.dot(direction);
        direction += (parts[k] - part) * pairs[k].step;
    }
    return direction;
}

}  // namespace

std::optional<double> search_slopes(OptimizerRun& run, const Eigen::VectorXf& direction,
                                    double longest, Evaluation& evaluation) {
    const Eigen::VectorXd along = direction.cast<double>();
    const double start = along.dot(evaluation.gradient);
    if (!(start < 0)) return std::nullopt;
    double low = 0;
    double low_slope = start;
    std::optional<double> high;
    double high_slope = 0;
    double t = std::min(1.0, longest);
    for (int trial = 0; trial < kSlopeTrials; ++trial) {
        const bool is_defined = run.evaluate(direction, t, evaluation);
        const double slope = is_defined ? along.dot(evaluation.gradient) : -start;
        const bool is_flat = slope >= kSteepest * start && slope <= kRising * start;
        if (is_defined && (is_flat || (slope < 0 && t >= longest))) return t;
        if (slope < 0) {
            low = t;
            low_slope = slope;
        } else {
            high = t;
            high_slope = slope;
        }
        const double part = high ? std::clamp(low_slope / (low_slope - high_slope), 0.1, 0.9) : 0;
        t = high ? low + part * (*high - low) : std::min(3 * t, longest);
    }
    return std::nullopt;
}

OptimizerResult minimize_convex(Objective& objective, const Eigen::VectorXd& scales,
                                const OptimizerOptions& options) {
    OptimizerRun run(objective, options);
    Evaluation here;
    Eigen::VectorXf direction = Eigen::VectorXf::Zero(objective.n_variables());
    if (!run.evaluate(direction, 0, here)) return run.finish(Stop::kStalled, here);
    std::deque<StepPair> pairs;
    for (;;) {
        if (const auto stop = run.before_iteration(here)) return run.finish(*stop, here);
        direction = descent(pairs, scales, here.gradient).cast<float>();
        const Eigen::VectorXd before = here.gradient;
        const auto t =
            search_slopes(run, direction, options.max_move / largest_move(direction), here);
        if (t) {
            run.accept();
            StepPair pair{*t * direction.cast<double>(), here.gradient - before, 0};
            const double curvature = pair.step.dot(pair.change);
            if (!(curvature > 0)) continue;
            pair.inverse = 1 / curvature;
            pairs.push_back(std::move(pair));
            if (std::ssize(pairs) > kConvexPairs) pairs.pop_front();
            continue;
        }
        // The direction is spoilt, by pairs from far away or by rounding: begin again.
        if (!run.evaluate(direction, 0, here) || pairs.empty()) {
            return run.finish(Stop::kStalled, here);
        }
        pairs.clear();
    }
}

}  // namespace pcvt
