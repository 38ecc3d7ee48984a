#include "mesher/lbfgs.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "mesher/lloyd.hpp"

namespace pcvt {
namespace {

using Eigen::VectorXd;

/// An ill-conditioned bowl sum k (x_k - 1)^2 with a gradient step that is safe, as Lloyd's is.
bool bowl(const VectorXd& x, Evaluation& e) {
    const VectorXd weight = VectorXd::LinSpaced(x.size(), 1, double(x.size()));
    const VectorXd d = x - VectorXd::Ones(x.size());
    e.value = weight.dot(d.cwiseAbs2());
    e.gradient = 2 * weight.cwiseProduct(d);
    e.lloyd_step = -e.gradient / (2 * double(x.size()));
    e.residual = e.rms_residual = e.lloyd_step.cwiseAbs().maxCoeff();
    return true;
}

/// Rosenbrock's curved valley: minimum 0 at (1, 1).
bool valley(const VectorXd& x, Evaluation& e) {
    const double bend = x[1] - x[0] * x[0];
    e.value = 100 * bend * bend + (1 - x[0]) * (1 - x[0]);
    e.gradient = Eigen::Vector2d(-400 * x[0] * bend - 2 * (1 - x[0]), 200 * bend);
    e.lloyd_step = -1e-3 * e.gradient;
    e.residual = e.rms_residual = e.gradient.norm();
    return true;
}

OptimizerOptions options(double tolerance, double max_move) {
    return {tolerance, -1, max_move, {}};
}

TEST(Lbfgs, FindsTheMinimumOfABowlAndOfACurvedValley) {
    const auto in_bowl = minimize_lbfgs(bowl, VectorXd::Zero(40), options(1e-10, 10));
    EXPECT_EQ(in_bowl.stop, Stop::kConverged);
    EXPECT_LT((in_bowl.x - VectorXd::Ones(40)).norm(), 1e-8);
    EXPECT_LT(in_bowl.evaluations, 100);
    const auto in_valley = minimize_lbfgs(valley, Eigen::Vector2d(-1.2, 1), options(1e-8, 0.5));
    EXPECT_EQ(in_valley.stop, Stop::kConverged);
    EXPECT_LT((in_valley.x - Eigen::Vector2d(1, 1)).norm(), 1e-6);
    EXPECT_LT(in_valley.evaluations, 80);
}

TEST(Lbfgs, NeverMovesAPairFurtherThanTheClamp) {
    VectorXd previous = VectorXd::Constant(10, 50);
    double longest = 0;
    const Objective watched = [&](const VectorXd& x, Evaluation& e) { return bowl(x, e); };
    OptimizerOptions clamped = options(1e-8, 0.25);
    VectorXd current = previous;
    const Objective recording = [&](const VectorXd& x, Evaluation& e) {
        current = x;
        return watched(x, e);
    };
    clamped.progress = [&](const Progress&) {
        for (Eigen::Index k = 0; k < current.size(); k += 2) {
            longest = std::max(longest, (current - previous).segment(k, 2).norm());
        }
        previous = current;
        return true;
    };
    EXPECT_EQ(minimize_lbfgs(recording, previous, clamped).stop, Stop::kConverged);
    EXPECT_LE(longest, 0.25 * (1 + 1e-12));
    EXPECT_GT(longest, 0.2);
}

TEST(Lbfgs, StepsBackFromWhereTheFunctionIsNotDefined) {
    const Objective walled = [](const VectorXd& x, Evaluation& e) {
        return x.maxCoeff() < 1.0005 && bowl(x, e);
    };
    const auto result = minimize_lbfgs(walled, VectorXd::Constant(6, -3), options(1e-9, 2));
    EXPECT_EQ(result.stop, Stop::kConverged);
    EXPECT_LT((result.x - VectorXd::Ones(6)).norm(), 1e-7);
}

/// Why a run ended, for both optimisers.
void expect_stops(OptimizerResult (*minimize)(const Objective&, const VectorXd&,
                                              const OptimizerOptions&)) {
    const VectorXd start = VectorXd::Zero(30);
    OptimizerOptions limited = options(1e-10, 10);
    limited.max_iterations = 3;
    const auto limit = minimize(bowl, start, limited);
    EXPECT_EQ(limit.stop, Stop::kIterationLimit);
    EXPECT_EQ(limit.iterations, 3);

    OptimizerOptions cancelled = options(1e-10, 10);
    cancelled.progress = [](const Progress& p) { return p.iteration < 2; };
    EXPECT_EQ(minimize(bowl, start, cancelled).stop, Stop::kCancelled);
    EXPECT_EQ(minimize(bowl, VectorXd::Ones(30), options(0, 10)).stop, Stop::kConverged);

    const Objective noisy = [](const VectorXd& x, Evaluation& e) {
        bowl(x, e);
        e.value += 100;
        e.residual += 0.5;
        return true;
    };
    EXPECT_EQ(minimize(noisy, start, options(0.1, 10)).stop, Stop::kStalled);
}

TEST(Lbfgs, TellsWhyItEnded) { expect_stops(minimize_lbfgs); }
TEST(Lloyd, TellsWhyItEnded) { expect_stops(minimize_lloyd); }

TEST(Lloyd, FollowsTheFixedPointSteps) {
    const VectorXd start = VectorXd::Zero(4);
    Evaluation e;
    bowl(start, e);
    OptimizerOptions one_step = options(0, 10);
    one_step.max_iterations = 1;
    EXPECT_EQ(minimize_lloyd(bowl, start, one_step).x, start + e.lloyd_step);
}

}  // namespace
}  // namespace pcvt
