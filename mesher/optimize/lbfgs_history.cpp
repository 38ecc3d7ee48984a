#include "mesher/optimize/lbfgs_history.hpp"

#include <algorithm>
#include <cmath>

#include "mesher/base/huge_pages.hpp"
#include "mesher/base/prefetch.hpp"
#include "mesher/base/target_clones.hpp"

namespace pcvt {
namespace {

/// If the slope along a step changes by less than this fraction of itself, the pair gives no
/// reliable estimate of the curvature.
constexpr double kWeakCurvature = 1e-3;
constexpr Eigen::Index kBlock = PackedVectors::kBlock;
constexpr Eigen::Index kBlocksPerTask = 16;
/// Doubles per cache line.
constexpr Eigen::Index kDoublesPerLine = 8;
/// Partial maxima, enough of them to hide the latency of a comparison.
constexpr Eigen::Index kLanes = 32;

PCVT_TARGET_CLONES void scale(float c, const float* x, float* y, Eigen::Index n) {
    for (Eigen::Index i = 0; i < n; ++i) y[i] = c * x[i];
}

/// Rounds n numbers to single precision and meanwhile prefetches the n numbers after them, which
/// are read next.
PCVT_TARGET_CLONES void narrow_to(const double* x, float* y, Eigen::Index n) {
    Eigen::Index i = 0;
    for (; i + kDoublesPerLine <= n; i += kDoublesPerLine) {
        prefetch(x + n + i);
        for (Eigen::Index k = 0; k < kDoublesPerLine; ++k) y[i + k] = static_cast<float>(x[i + k]);
    }
    for (; i < n; ++i) y[i] = static_cast<float>(x[i]);
}

PCVT_TARGET_CLONES void subtract(const float* x, const float* y, float* difference,
                                 Eigen::Index n) {
    for (Eigen::Index i = 0; i < n; ++i) difference[i] = x[i] - y[i];
}

PCVT_TARGET_CLONES double largest_pair_square(const float* x, Eigen::Index n) {
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

/// A range of variables that shares one scale.
struct Block {
    Eigen::Index number;
    Eigen::Index first;
    Eigen::Index n;
};

void narrow(const Eigen::VectorXd& x, const Block& block, float* y) {
    narrow_to(x.data() + block.first, y, block.n);
}

/// Runs work(block, sums of its task) over all variables; returns the totals.
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

struct NoSums {
    void add(const NoSums&) {}
};

/// Sums over a new direction.
struct DirectionSums {
    double slope = 0;
    double largest_square = 0;

    void add(const DirectionSums& other) {
        slope += other.slope;
        largest_square = std::max(largest_square, other.largest_square);
    }
};

/// Sums over a trial point: s.g and z.g for each pair, d.y and y.z for the trial step.
struct TrialSums {
    std::array<double, LbfgsHistory::kPairs> sg{};
    std::array<double, LbfgsHistory::kPairs> zg{};
    double dy = 0;
    double yz = 0;

    void add(const TrialSums& other) {
        for (int k = 0; k < LbfgsHistory::kPairs; ++k) {
            sg[k] += other.sg[k];
            zg[k] += other.zg[k];
        }
        dy += other.dy;
        yz += other.yz;
    }
};

}  // namespace

/// The coefficients of a direction: of the gradient, of each s and of each y.
struct LbfgsHistory::Coefficients {
    double gradient;
    PerSlot<double> step;
    PerSlot<double> change;
};

LbfgsHistory::LbfgsHistory(Eigen::Index n_variables, Workers& workers)
    : workers_(workers),
      n_variables_(n_variables),
      direction_(n_variables),
      packed_(2 * kPairs, n_variables),
      gradients_(2, n_variables) {
    prefer_huge_pages(direction_);
    make_room_for_trial();
}

void LbfgsHistory::make_room_for_trial() {
    if (slots_.size() == kPairs) slots_.erase(slots_.begin());
    trial_ = 0;
    while (std::find(slots_.begin(), slots_.end(), trial_) != slots_.end()) ++trial_;
}

LbfgsHistory::Coefficients LbfgsHistory::two_loops() const {
    // First loop: from the newest pair to the oldest.
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
    // Scale the initial Hessian by the newest pair.
    const int newest = slots_.back();
    const double gamma = sy_[newest][newest] / yz_[newest][newest];
    // Second loop: from the oldest pair to the newest.
    for (std::size_t k = 0; k < slots_.size(); ++k) {
        const int i = slots_[k];
        double yr = zg_[i];
        for (const int j : slots_) yr -= alpha[j] * yz_[i][j];
        yr *= gamma;
        for (std::size_t m = 0; m < k; ++m) {
            const int j = slots_[m];
            yr += (alpha[j] - beta[j]) * sy_[j][i];
        }
        beta[i] = yr / sy_[i][i];
    }
    // Convert to coefficients of the stored directions and changes.
    Coefficients c{-gamma, {}, {}};
    for (const int i : slots_) {
        c.step[i] = (beta[i] - alpha[i]) * scale_[i];
        c.change[i] = gamma * alpha[i];
    }
    return c;
}

void LbfgsHistory::begin(const Evaluation& here) {
    slots_.clear();
    if (here.preconditioned.size() > 0 && !preconditioned_)
        preconditioned_.emplace(2, n_variables_);
    sweep<NoSums>(workers_, n_variables_, [&](const Block& block, NoSums&) {
        std::array<float, kBlock> g;
        narrow(here.gradient, block, g.data());
        gradients_.pack(here_, block.number, g.data());
        if (!preconditioned_) return;
        std::copy_n(here.preconditioned.data() + block.first, block.n, g.data());
        preconditioned_->pack(here_, block.number, g.data());
    });
}

LbfgsHistory::Direction LbfgsHistory::compute_direction() {
    // Compute the coefficients; the oldest pair makes room for the trial step.
    const std::vector<int> pairs = slots_;
    Coefficients c{};
    if (!pairs.empty()) {
        c = two_loops();
        make_room_for_trial();
    }
    // Combine the direction block by block and round it to the stored values.
    const auto work = [&](const Block& block, DirectionSums& sums) {
        std::array<float, kBlock> g;
        float* const d = direction_.data() + block.first;
        gradients_.unpack(here_, block.number, g.data());
        if (!pairs.empty()) {
            if (preconditioned_) {
                preconditioned_->unpack(here_, block.number, d);
                scale(static_cast<float>(c.gradient), d, d, block.n);
            } else {
                scale(static_cast<float>(c.gradient), g.data(), d, block.n);
            }
            for (const int k : pairs) {
                packed_.add_multiple(step(k), block.number, static_cast<float>(c.step[k]), d);
                packed_.add_multiple(change(k), block.number, static_cast<float>(c.change[k]), d);
            }
        }
        packed_.pack(step(trial_), block.number, d);
        sums.slope += packed_.dot(step(trial_), block.number, g.data());
        sums.largest_square = std::max(sums.largest_square, largest_pair_square(d, block.n));
    };
    const auto sums = sweep<DirectionSums>(workers_, n_variables_, work);
    slope_ = sums.slope;
    return {sums.slope, std::sqrt(sums.largest_square)};
}

double LbfgsHistory::directional_derivative(const Evaluation& there) {
    // Select the pairs whose products with the trial gradient are needed.
    const int next = 1 - here_;
    std::vector<int> measured = slots_;
    measured.push_back(trial_);
    // Store the gradient and its change block by block, and take the dot products.
    const auto work = [&](const Block& block, TrialSums& sums) {
        std::array<float, kBlock> g;
        std::array<float, kBlock> y;
        narrow(there.gradient, block, g.data());
        gradients_.unpack(here_, block.number, y.data());
        subtract(g.data(), y.data(), y.data(), block.n);
        if (preconditioned_) {
            std::array<float, kBlock> p;
            std::array<float, kBlock> z;
            std::copy_n(there.preconditioned.data() + block.first, block.n, p.data());
            preconditioned_->unpack(here_, block.number, z.data());
            subtract(p.data(), z.data(), z.data(), block.n);
            packed_.pack(change(trial_), block.number, z.data());
            preconditioned_->pack(next, block.number, p.data());
        } else {
            packed_.pack(change(trial_), block.number, y.data());
        }
        sums.dy += packed_.dot(step(trial_), block.number, y.data());
        sums.yz += packed_.dot(change(trial_), block.number, y.data());
        for (const int k : measured) {
            sums.sg[k] += packed_.dot(step(k), block.number, g.data());
            sums.zg[k] += packed_.dot(change(k), block.number, g.data());
        }
        gradients_.pack(next, block.number, g.data());
    };
    // Sweep over all variables and scale the products to s = scale * direction.
    const auto sums = sweep<TrialSums>(workers_, n_variables_, work);
    scale_[trial_] = 1;
    for (const int k : measured) {
        sg_there_[k] = scale_[k] * sums.sg[k];
        zg_there_[k] = sums.zg[k];
    }
    sy_[trial_][trial_] = sums.dy;
    yz_[trial_][trial_] = sums.yz;
    return sums.sg[trial_];
}

void LbfgsHistory::append_pair(double t) {
    here_ = 1 - here_;
    const int added = trial_;
    const double change_of_slope = sy_[added][added];
    if (!(change_of_slope > kWeakCurvature * std::abs(slope_))) {
        slots_.clear();
        return;
    }
    for (const int k : slots_) {
        sy_[k][added] = sg_there_[k] - sg_[k];
        yz_[k][added] = yz_[added][k] = zg_there_[k] - zg_[k];
    }
    scale_[added] = t;
    sy_[added][added] *= t;
    sg_there_[added] *= t;
    slots_.push_back(added);
    sg_ = sg_there_;
    zg_ = zg_there_;
}

}  // namespace pcvt
