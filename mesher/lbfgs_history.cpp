#include "mesher/lbfgs_history.hpp"

#include <algorithm>
#include <cmath>

#include "mesher/vector_clones.hpp"

namespace pcvt {
namespace {

/// A pair with s.y below this times |s| |y| says nothing reliable about the curvature.
constexpr double kWeakCurvature = 1e-8;
constexpr Eigen::Index kBlock = PackedVectors::kBlock;
constexpr Eigen::Index kBlocksPerTask = 16;
/// Partial sums and maxima: enough that they do not wait for each other.
constexpr Eigen::Index kLanes = 8;

PCVT_VECTOR_CLONES void narrow(double c, const double* x, float* y, Eigen::Index n) {
    for (Eigen::Index i = 0; i < n; ++i) y[i] = static_cast<float>(c * x[i]);
}

PCVT_VECTOR_CLONES void subtract(const double* x, const double* y, float* difference,
                                 Eigen::Index n) {
    for (Eigen::Index i = 0; i < n; ++i) difference[i] = static_cast<float>(x[i] - y[i]);
}

PCVT_VECTOR_CLONES double dot(const float* x, const float* y, Eigen::Index n) {
    double lane[kLanes] = {};
    Eigen::Index i = 0;
    for (; i + kLanes <= n; i += kLanes) {
        for (Eigen::Index k = 0; k < kLanes; ++k) lane[k] += double(x[i + k]) * double(y[i + k]);
    }
    for (; i < n; ++i) lane[i % kLanes] += double(x[i]) * double(y[i]);
    double sum = 0;
    for (const double part : lane) sum += part;
    return sum;
}

PCVT_VECTOR_CLONES double largest_pair_square(const float* x, Eigen::Index n) {
    float largest[kLanes] = {};
    Eigen::Index i = 0;
    for (; i + 2 * kLanes <= n; i += 2 * kLanes) {
        for (Eigen::Index k = 0; k < kLanes; ++k) {
            const float a = x[i + 2 * k];
            const float b = x[i + 2 * k + 1];
            largest[k] = std::max(largest[k], a * a + b * b);
        }
    }
    for (; i < n; i += 2) largest[0] = std::max(largest[0], x[i] * x[i] + x[i + 1] * x[i + 1]);
    return *std::max_element(std::begin(largest), std::end(largest));
}

/// A range of the variables that is stored under one scale.
struct Block {
    Eigen::Index number;
    Eigen::Index first;
    Eigen::Index n;
};

/// Runs work(block, sums of its task) over all variables; returns the added sums.
template <class Sums, class Work>
Sums sweep(Workers& workers, Eigen::Index n_variables, const Work& work) {
    const Eigen::Index n_blocks = (n_variables + kBlock - 1) / kBlock;
    const auto n_tasks = static_cast<int>((n_blocks + kBlocksPerTask - 1) / kBlocksPerTask);
    std::vector<Sums> sums(static_cast<std::size_t>(n_tasks));
    workers.for_each(n_tasks, [&](int task) {
        const Eigen::Index begin = task * kBlocksPerTask;
        for (Eigen::Index b = begin; b < std::min(begin + kBlocksPerTask, n_blocks); ++b) {
            work({b, b * kBlock, std::min(kBlock, n_variables - b * kBlock)}, sums[task]);
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

    void look_at(const float* g, const float* d, Eigen::Index n) {
        slope += dot(g, d, n);
        squared += dot(d, d, n);
        largest_square = std::max(largest_square, largest_pair_square(d, n));
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
    : workers_(workers),
      n_variables_(n_variables),
      direction_(n_variables),
      packed_(2 * kPairs, n_variables) {
    make_room_for_trial();
}

void LbfgsHistory::make_room_for_trial() {
    if (slots_.size() == kPairs) slots_.erase(slots_.begin());
    trial_ = 0;
    while (std::find(slots_.begin(), slots_.end(), trial_) != slots_.end()) ++trial_;
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
        make_room_for_trial();
    }
    const auto work = [&](const Block& block, DirectionSums& sums) {
        std::array<float, kBlock> g;
        float* const d = direction_.data() + block.first;
        narrow(1, gradient.data() + block.first, g.data(), block.n);
        if (!pairs.empty()) {
            narrow(c.gradient, gradient.data() + block.first, d, block.n);
            for (const int k : pairs) {
                packed_.add_multiple(step(k), block.number, static_cast<float>(c.step[k]), d);
                packed_.add_multiple(change(k), block.number, static_cast<float>(c.change[k]), d);
            }
        }
        packed_.pack(step(trial_), block.number, d);
        sums.look_at(g.data(), d, block.n);
    };
    const auto sums = sweep<DirectionSums>(workers_, n_variables_, work);
    squared_direction_ = sums.squared;
    return {sums.slope, std::sqrt(sums.largest_square)};
}

double LbfgsHistory::look(const Eigen::VectorXd& here, const Eigen::VectorXd& there) {
    const auto work = [&](const Block& block, LookSums& sums) {
        std::array<float, kBlock> g;
        std::array<float, kBlock> y;
        narrow(1, there.data() + block.first, g.data(), block.n);
        subtract(there.data() + block.first, here.data() + block.first, y.data(), block.n);
        packed_.pack(change(trial_), block.number, y.data());
        sums.dg += double(packed_.dot(step(trial_), block.number, g.data()));
        sums.dy += double(packed_.dot(step(trial_), block.number, y.data()));
        sums.yy += dot(y.data(), y.data(), block.n);
        sums.y_g += dot(y.data(), g.data(), block.n);
        for (const int k : slots_) {
            sums.sg[k] += double(packed_.dot(step(k), block.number, g.data()));
            sums.yg[k] += double(packed_.dot(change(k), block.number, g.data()));
        }
    };
    const auto sums = sweep<LookSums>(workers_, n_variables_, work);
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
