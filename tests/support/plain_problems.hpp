#pragma once

#include <algorithm>

#include "tests/support/plain_objective.hpp"

namespace pcvt::testing {

/// An ill-conditioned bowl sum k (x_k - 1)^2.
inline bool bowl(const Eigen::VectorXd& x, Evaluation& e) {
    const Eigen::VectorXd weight = Eigen::VectorXd::LinSpaced(x.size(), 1, double(x.size()));
    const Eigen::VectorXd d = x - Eigen::VectorXd::Ones(x.size());
    e.value = weight.dot(d.cwiseAbs2());
    e.gradient = 2 * weight.cwiseProduct(d);
    e.residual = e.rms_residual = e.gradient.cwiseAbs().maxCoeff() / (2 * double(x.size()));
    return true;
}

/// Rosenbrock's curved valley: minimum 0 at (1, 1).
inline bool valley(const Eigen::VectorXd& x, Evaluation& e) {
    const double bend = x[1] - x[0] * x[0];
    e.value = 100 * bend * bend + (1 - x[0]) * (1 - x[0]);
    e.gradient = Eigen::Vector2d(-400 * x[0] * bend - 2 * (1 - x[0]), 200 * bend);
    e.residual = e.rms_residual = e.gradient.norm();
    return true;
}

inline OptimizerOptions options(double tolerance, double max_move) {
    return {tolerance, -1, max_move, {}};
}

/// Records the longest move of a pair of variables in one iteration.
class MoveWatch {
   public:
    explicit MoveWatch(const PlainObjective& objective)
        : objective_(objective), previous_(objective.point()) {}

    OptimizerOptions with(OptimizerOptions options) {
        options.progress = [this](const Progress&) {
            const Eigen::VectorXd move = objective_.point() - previous_;
            const double longest = move.reshaped(2, move.size() / 2).colwise().norm().maxCoeff();
            longest_ = std::max(longest_, longest);
            previous_ = objective_.point();
            return true;
        };
        return options;
    }
    double longest() const { return longest_; }

   private:
    const PlainObjective& objective_;
    Eigen::VectorXd previous_;
    double longest_ = 0;
};

}  // namespace pcvt::testing
