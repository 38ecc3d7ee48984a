#include "mesher/lbfgs.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <optional>
#include <vector>

#include "mesher/optimizer_run.hpp"

namespace pcvt {
namespace {

using Eigen::VectorXd;

constexpr std::size_t kHistory = 7;
/// A pair with s.y below this times |s| |y| says nothing reliable about the curvature.
constexpr double kWeakCurvature = 1e-8;
/// Weak Wolfe: F(t) <= F(0) + c1 t F'(0) and F'(t) >= c2 F'(0).
constexpr double kDecrease = 1e-4;
constexpr double kCurvature = 0.9;
/// Values that differ by less than this, relatively, count as equal (approximate Wolfe).
constexpr double kEqualValues = 1e-12;
constexpr int kTrials = 25;

/// The pairs (s, y) and the product with the inverse Hessian that they approximate.
class History {
   public:
    bool empty() const { return pairs_.empty(); }
    void clear() { pairs_.clear(); }

    /// Returns false, and forgets everything, where the curvature along s is weak.
    bool add(VectorXd s, VectorXd y) {
        const double sy = s.dot(y);
        if (!(sy > kWeakCurvature * s.norm() * y.norm())) {
            clear();
            return false;
        }
        if (pairs_.size() == kHistory) pairs_.pop_front();
        pairs_.push_back({std::move(s), std::move(y), sy});
        return true;
    }

    /// The two-loop recursion.
    VectorXd times(VectorXd q) const {
        std::vector<double> alpha(pairs_.size());
        for (std::size_t k = pairs_.size(); k-- > 0;) {
            alpha[k] = pairs_[k].s.dot(q) / pairs_[k].sy;
            q -= alpha[k] * pairs_[k].y;
        }
        q *= pairs_.back().sy / pairs_.back().y.squaredNorm();
        for (std::size_t k = 0; k < pairs_.size(); ++k) {
            const double beta = pairs_[k].y.dot(q) / pairs_[k].sy;
            q += (alpha[k] - beta) * pairs_[k].s;
        }
        return q;
    }

   private:
    struct Pair {
        VectorXd s;
        VectorXd y;
        double sy;
    };
    std::deque<Pair> pairs_;
};

/// The values along a line: F(t) and F'(t).
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
    const bool equal = std::abs(trial.value - start.value) <= kEqualValues * std::abs(start.value);
    const bool approximate = trial.slope <= (2 * kDecrease - 1) * start.slope;
    if (equal && approximate) return curvature ? Verdict::kAccept : Verdict::kTooShort;
    return Verdict::kTooLong;
}

/// The minimiser of the parabola through the values at both ends and the slope at `low`, kept away
/// from the ends.
double interpolate(const LinePoint& low, const LinePoint& high) {
    const double width = high.t - low.t;
    const double curvature = (high.value - low.value) / width - low.slope;
    double fraction = 0.5;
    if (curvature > 0) fraction = -0.5 * low.slope / curvature;
    return low.t + std::clamp(fraction, 0.1, 0.9) * width;
}

/// Looks along x + t d for 0 < t <= longest; returns whether `there` and `x_there` hold a step.
bool search_line(OptimizerRun& run, const VectorXd& x, const Evaluation& here, const VectorXd& d,
                 double longest, VectorXd& x_there, Evaluation& there) {
    const LinePoint start{0, here.value, here.gradient.dot(d)};
    LinePoint low = start;
    std::optional<LinePoint> high;
    double t = std::min(1.0, longest);
    for (int trial = 0; trial < kTrials; ++trial) {
        x_there = x + t * d;
        if (!run.evaluate(x_there, there) || !std::isfinite(there.value)) {
            high = LinePoint{t, std::numeric_limits<double>::infinity(), 0};
        } else {
            const LinePoint point{t, there.value, there.gradient.dot(d)};
            const Verdict verdict = judge(start, point);
            if (verdict == Verdict::kAccept) return true;
            if (verdict == Verdict::kTooShort && t >= longest) return true;
            if (verdict == Verdict::kTooShort) low = point;
            if (verdict == Verdict::kTooLong) high = point;
        }
        t = high ? interpolate(low, *high) : std::min(3 * t, longest);
    }
    return false;
}

}  // namespace

OptimizerResult minimize_lbfgs(const Objective& objective, const VectorXd& start,
                               const OptimizerOptions& options) {
    OptimizerRun run(objective, options);
    History history;
    VectorXd x = start;
    VectorXd x_there;
    Evaluation here;
    Evaluation there;
    if (!run.evaluate(x, here)) return run.finish(Stop::kStalled, x, here);
    for (;;) {
        if (const auto stop = run.before_iteration(here)) return run.finish(*stop, x, here);
        for (;;) {
            const bool fresh = history.empty();
            VectorXd d = fresh ? here.lloyd_step : VectorXd(-history.times(here.gradient));
            const double longest = options.max_move / largest_move(d);
            const bool downhill = here.gradient.dot(d) < 0;
            if (downhill && search_line(run, x, here, d, longest, x_there, there)) break;
            if (fresh) return run.finish(Stop::kStalled, x, here);
            history.clear();
        }
        history.add(x_there - x, there.gradient - here.gradient);
        std::swap(x, x_there);
        std::swap(here, there);
    }
}

}  // namespace pcvt
