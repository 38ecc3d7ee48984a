#include "mesher/lbfgs_history.hpp"

#include <algorithm>
#include <cmath>

#include "mesher/vector_clones.hpp"

namespace pcvt {
namespace {

/// A pair with s.y below this times |s| |y| says nothing reliable about the curvature.
constexpr double kWeakCurvature = 1e-8;
/// Variables of one task, and of one block of it, whose doubles stay in the nearest cache.
constexpr Eigen::Index kVariablesPerTask = 1 << 15;
constexpr Eigen::Index kBlock = 1 << 11;
/// Partial sums of a dot product: enough that additions do not wait for each other.
constexpr Eigen::Index kLanes = 8;
/// Single-precision numbers that are fetched together, and how far ahead of their use: where a
/// vector goes over to its next page the hardware does not do so by itself.
constexpr Eigen::Index kStretch = 64;
constexpr Eigen::Index kAhead = 512;
constexpr Eigen::Index kPerCacheLine = 16;

inline void fetch_ahead(const float* x) {
    for (Eigen::Index k = 0; k < kStretch; k += kPerCacheLine) __builtin_prefetch(x + kAhead + k);
}

PCVT_VECTOR_CLONES double dot(const double* x, const float* y, Eigen::Index n) {
    double lane[kLanes] = {};
    Eigen::Index i = 0;
    for (; i + kStretch <= n; i += kStretch) {
        fetch_ahead(y + i);
        for (Eigen::Index j = i; j < i + kStretch; j += kLanes) {
            for (Eigen::Index k = 0; k < kLanes; ++k) lane[k] += x[j + k] * double(y[j + k]);
        }
    }
    for (; i < n; ++i) lane[i % kLanes] += x[i] * double(y[i]);
    double sum = 0;
    for (const double part : lane) sum += part;
    return sum;
}

PCVT_VECTOR_CLONES void add_multiple(double c, const float* x, double* sum, Eigen::Index n) {
    Eigen::Index i = 0;
    for (; i + kStretch <= n; i += kStretch) {
        fetch_ahead(x + i);
        for (Eigen::Index k = 0; k < kStretch; ++k) sum[i + k] += c * double(x[i + k]);
    }
    for (; i < n; ++i) sum[i] += c * double(x[i]);
}

PCVT_VECTOR_CLONES double largest_pair_square(const double* x, Eigen::Index n) {
    double largest[kLanes / 2] = {};
    Eigen::Index i = 0;
    for (; i + kLanes <= n; i += kLanes) {
        for (Eigen::Index k = 0; k < kLanes / 2; ++k) {
            const double square = x[i + 2 * k] * x[i + 2 * k] + x[i + 2 * k + 1] * x[i + 2 * k + 1];
            largest[k] = std::max(largest[k], square);
        }
    }
    for (; i < n; i += 2) largest[0] = std::max(largest[0], x[i] * x[i] + x[i + 1] * x[i + 1]);
    return *std::max_element(std::begin(largest), std::end(largest));
}

/// Runs task(first, n, sums of the task) over ranges of the variables; returns the added sums.
template <class Sums, class Task>
Sums sweep(Workers& workers, Eigen::Index n_variables, const Task& task) {
    const auto n_tasks =
        static_cast<int>((n_variables + kVariablesPerTask - 1) / kVariablesPerTask);
    std::vector<Sums> sums(static_cast<std::size_t>(n_tasks));
    workers.for_each(n_tasks, [&](int k) {
        const Eigen::Index first = k * kVariablesPerTask;
        const Eigen::Index end = std::min(first + kVariablesPerTask, n_variables);
        for (Eigen::Index i = first; i < end; i += kBlock) {
            task(i, std::min(kBlock, end - i), sums[k]);
        }
    });
    for (std::size_t k = 1; k < sums.size(); ++k) sums.front().add(sums[k]);
    return sums.front();
}

/// What is summed over a direction d at the gradient g.
struct DirectionSums {
    double slope = 0;
    double squared = 0;
    double largest_square = 0;

    /// @param wide  the same numbers as d.
    void look_at(const double* g, const float* d, const double* wide, Eigen::Index n) {
        slope += dot(g, d, n);
        squared += dot(wide, d, n);
        largest_square = std::max(largest_square, largest_pair_square(wide, n));
    }
    void add(const DirectionSums& other) {
        slope += other.slope;
        squared += other.squared;
        largest_square = std::max(largest_square, other.largest_square);
    }
};

/// What is summed at a trial point.
struct LookSums {
    std::array<double, LbfgsHistory::kPairs> sg{};
    std::array<double, LbfgsHistory::kPairs> yg{};
    double dg = 0;
    double dy = 0;
    double yy = 0;
    double y_g = 0;

    void add(const LookSums& other) {
        for (int k = 0; k < LbfgsHistory::kPairs; ++k) {
            sg[k] += other.sg[k];
            yg[k] += other.yg[k];
        }
        dg += other.dg;
        dy += other.dy;
        yy += other.yy;
        y_g += other.y_g;
    }
};

}  // namespace

/// Of a direction: of the gradient, of each s and of each y.
struct LbfgsHistory::Coefficients {
    double gradient;
    PerSlot<double> step;
    PerSlot<double> change;
};

LbfgsHistory::LbfgsHistory(Eigen::Index n_variables, Workers& workers)
    : workers_(workers), n_variables_(n_variables) {
    step_[trial_].resize(n_variables);
    change_[trial_].resize(n_variables);
}

LbfgsHistory::Coefficients LbfgsHistory::two_loops() const {
    PerSlot<double> alpha{};
    PerSlot<double> beta{};
    for (std::size_t k = slots_.size(); k-- > 0;) {
        const int i = slots_[k];
        double sq = sg_[i];
        for (std::size_t m = k + 1; m < slots_.size(); ++m) {
            sq -= alpha[slots_[m]] * sy_[i][slots_[m]];
        }
        alpha[i] = sq / sy_[i][i];
    }
    const int newest = slots_.back();
    const double gamma = sy_[newest][newest] / yy_[newest][newest];
    for (std::size_t k = 0; k < slots_.size(); ++k) {
        const int i = slots_[k];
        double yr = yg_[i];
        for (const int j : slots_) yr -= alpha[j] * yy_[i][j];
        yr *= gamma;
        for (std::size_t m = 0; m < k; ++m) {
            const int j = slots_[m];
            yr += (alpha[j] - beta[j]) * sy_[j][i];
        }
        beta[i] = yr / sy_[i][i];
    }
    Coefficients c{-gamma, {}, {}};
    for (const int i : slots_) {
        c.step[i] = (beta[i] - alpha[i]) * scale_[i];
        c.change[i] = gamma * alpha[i];
    }
    return c;
}

LbfgsHistory::Direction LbfgsHistory::aim(const Eigen::VectorXd& gradient) {
    const std::vector<int> pairs = slots_;
    Coefficients c{};
    if (!pairs.empty()) {
        c = two_loops();
        if (pairs.size() == kPairs) slots_.erase(slots_.begin());
        trial_ = 0;
        while (std::find(slots_.begin(), slots_.end(), trial_) != slots_.end()) ++trial_;
        step_[trial_].resize(n_variables_);
        change_[trial_].resize(n_variables_);
    }
    const auto sums = sweep<DirectionSums>(
        workers_, n_variables_, [&](Eigen::Index first, Eigen::Index n, DirectionSums& part) {
            const double* g = gradient.data() + first;
            float* d = step_[trial_].data() + first;
            std::array<double, kBlock> wide;
            if (!pairs.empty()) {
                for (Eigen::Index i = 0; i < n; ++i) wide[i] = c.gradient * g[i];
                for (const int k : pairs) {
                    add_multiple(c.step[k], step_[k].data() + first, wide.data(), n);
                    add_multiple(c.change[k], change_[k].data() + first, wide.data(), n);
                }
                std::transform(wide.data(), wide.data() + n, d,
                               [](double x) { return static_cast<float>(x); });
            }
            std::copy_n(d, n, wide.data());
            part.look_at(g, d, wide.data(), n);
        });
    squared_direction_ = sums.squared;
    return {sums.slope, std::sqrt(sums.largest_square)};
}

double LbfgsHistory::look(const Eigen::VectorXd& here, const Eigen::VectorXd& there) {
    const auto sums = sweep<LookSums>(workers_, n_variables_,
                                      [&](Eigen::Index first, Eigen::Index n, LookSums& part) {
                                          const double* g = there.data() + first;
                                          const float* d = step_[trial_].data() + first;
                                          float* y = change_[trial_].data() + first;
                                          std::array<double, kBlock> wide;
                                          for (Eigen::Index i = 0; i < n; ++i)
                                              y[i] = static_cast<float>(g[i] - here[first + i]);
                                          std::copy_n(y, n, wide.data());
                                          part.dg += dot(g, d, n);
                                          part.dy += dot(wide.data(), d, n);
                                          part.yy += dot(wide.data(), y, n);
                                          part.y_g += dot(g, y, n);
                                          for (const int k : slots_) {
                                              part.sg[k] += dot(g, step_[k].data() + first, n);
                                              part.yg[k] += dot(g, change_[k].data() + first, n);
                                          }
                                      });
    for (const int k : slots_) {
        sg_there_[k] = scale_[k] * sums.sg[k];
        yg_there_[k] = sums.yg[k];
    }
    sg_there_[trial_] = sums.dg;
    yg_there_[trial_] = sums.y_g;
    sy_[trial_][trial_] = sums.dy;
    yy_[trial_][trial_] = sums.yy;
    return sums.dg;
}

void LbfgsHistory::add(double t) {
    const int added = trial_;
    const double dy = sy_[added][added];
    if (!(dy > kWeakCurvature * std::sqrt(squared_direction_ * yy_[added][added]))) {
        clear();
        return;
    }
    for (const int k : slots_) {
        sy_[k][added] = sg_there_[k] - sg_[k];
        yy_[k][added] = yy_[added][k] = yg_there_[k] - yg_[k];
    }
    scale_[added] = t;
    sy_[added][added] = t * dy;
    sg_there_[added] *= t;
    slots_.push_back(added);
    sg_ = sg_there_;
    yg_ = yg_there_;
}

}  // namespace pcvt
