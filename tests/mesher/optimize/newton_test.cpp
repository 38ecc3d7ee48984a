#include "mesher/optimize/newton.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "mesher/optimize/conjugate_gradients.hpp"
#include "tests/support/plain_problems.hpp"

namespace pcvt {
namespace {

using Eigen::VectorXd;
using testing::bowl;
using testing::MoveWatch;
using testing::options;
using testing::PlainObjective;
using testing::valley;

constexpr int kNeverGiveUp = std::numeric_limits<int>::max();

/// x^4 / 4 - x^2 / 2 + y^2: a saddle at the origin between minima -1/4 at (1, 0) and (-1, 0).
bool two_wells(const VectorXd& x, Evaluation& e) {
    e.value = std::pow(x[0], 4) / 4 - x[0] * x[0] / 2 + x[1] * x[1];
    e.gradient = Eigen::Vector2d(std::pow(x[0], 3) - x[0], 2 * x[1]);
    e.residual = e.rms_residual = e.gradient.norm();
    return true;
}

/// A chain of variables on stiffening springs, sum cosh(x_{k+1} - x_k) + cosh(x_k) / 100:
/// ill-conditioned.
bool spring_chain(const VectorXd& x, Evaluation& e) {
    e.value = 0;
    e.gradient = x.array().sinh() / 100;
    for (Eigen::Index k = 0; k + 1 < x.size(); ++k) {
        e.value += std::cosh(x[k + 1] - x[k]) - 1;
        e.gradient[k + 1] += std::sinh(x[k + 1] - x[k]);
        e.gradient[k] -= std::sinh(x[k + 1] - x[k]);
    }
    e.value += (x.array().cosh() - 1).sum() / 100;
    e.residual = e.rms_residual = e.gradient.norm();
    return true;
}

OptimizerResult newton(PlainObjective& objective, const OptimizerOptions& options,
                       int most_truncated = kNeverGiveUp) {
    Workers workers(1);
    Evaluation here;
    EXPECT_TRUE(objective.evaluate({}, 0, here));
    return minimize_newton(objective, options, here, most_truncated, workers);
}

TEST(Newton, SolvesAQuadraticProblemInFewSteps) {
    PlainObjective objective(bowl, VectorXd::Zero(40), 1);
    const OptimizerResult result = newton(objective, options(1e-10, 100));
    EXPECT_EQ(result.run.stop, Stop::kConverged);
    EXPECT_LT((objective.point() - VectorXd::Ones(40)).norm(), 1e-8);
    EXPECT_LE(result.run.evaluations, 10);
    EXPECT_EQ(result.run.hessians, result.run.iterations);
    EXPECT_GE(result.run.cg_products, result.run.hessians);
    EXPECT_EQ(result.run.evaluations + 1, objective.n_evaluations());
}

TEST(Newton, FollowsACurvedValleyDown) {
    PlainObjective objective(valley, Eigen::Vector2d(-1.2, 1), 1);
    double previous = 1e300;
    OptimizerOptions watched = options(1e-11, 0.5);
    watched.progress = [&](const Progress& p) {
        EXPECT_LE(p.value, previous);
        previous = p.value;
        return true;
    };
    const OptimizerResult result = newton(objective, watched);
    EXPECT_EQ(result.run.stop, Stop::kConverged);
    EXPECT_LT(result.run.evaluations, 60);
}

// The accuracy of the linear systems increases near the minimum.
TEST(Newton, ConvergesSuperlinearly) {
    PlainObjective objective(spring_chain, VectorXd::LinSpaced(60, -1, 1).array().sin(), 1);
    double previous = 1;
    OptimizerOptions watched = options(1e-11, 10);
    watched.progress = [&](const Progress& p) {
        EXPECT_LT(p.residual, std::max(1e-11, 5 * std::pow(previous, 1.4)));
        previous = p.residual;
        return true;
    };
    const OptimizerResult result = newton(objective, watched);
    EXPECT_EQ(result.run.stop, Stop::kConverged);
    EXPECT_LE(result.run.evaluations, 7);
    RecordProperty("evaluations", result.run.evaluations);
}

// Directions of negative curvature lead away from a saddle.
TEST(Newton, LeavesASaddle) {
    for (const double x : {1e-6, -1e-3, 0.3}) {
        PlainObjective objective(two_wells, Eigen::Vector2d(x, 0.5), 1);
        EXPECT_EQ(newton(objective, options(1e-9, 0.5)).run.stop, Stop::kConverged);
        EXPECT_NEAR(objective.point()[0], x > 0 ? 1 : -1, 1e-8);
    }
}

TEST(Newton, NeverMovesAPairFurtherThanTheClamp) {
    const VectorXd start = VectorXd::Constant(10, 50);
    PlainObjective objective(bowl, start, 1);
    MoveWatch watch(objective);
    EXPECT_EQ(newton(objective, watch.with(options(1e-8, 0.25))).run.stop, Stop::kConverged);
    EXPECT_LE(watch.longest(), 0.25 * (1 + 1e-6));
    EXPECT_GT(watch.longest(), 0.2);
}

TEST(Newton, GivesUpAfterTruncatedSteps) {
    PlainObjective far(bowl, VectorXd::Constant(10, 50), 1);
    const OptimizerResult result = newton(far, options(1e-8, 0.25), 4);
    EXPECT_EQ(result.run.stop, Stop::kStalled);
    EXPECT_EQ(result.run.iterations, 5);
}

TEST(Newton, StepsBackFromWhereTheFunctionIsNotDefined) {
    const auto walled = [](const VectorXd& x, Evaluation& e) {
        return x.maxCoeff() < 1.4 && bowl(x, e);
    };
    const VectorXd start = VectorXd::Constant(6, -3);
    PlainObjective objective(walled, start, 1);
    EXPECT_EQ(newton(objective, options(1e-9, 20)).run.stop, Stop::kConverged);
    PlainObjective at_start_only(
        [&](const VectorXd& x, Evaluation& e) { return bowl(x, e) && x == start; }, start, 1);
    EXPECT_EQ(newton(at_start_only, options(1e-9, 20)).run.stop, Stop::kStalled);
    EXPECT_EQ(at_start_only.point(), start);
}

TEST(Newton, ReportsWhyItEnded) {
    PlainObjective limited(valley, Eigen::Vector2d(-1.2, 1), 1);
    OptimizerOptions three = options(1e-10, 0.1);
    three.max_iterations = 3;
    const OptimizerResult limit = newton(limited, three);
    EXPECT_EQ(limit.run.stop, Stop::kIterationLimit);
    EXPECT_EQ(limit.run.iterations, 3);
    OptimizerOptions cancelled = options(1e-10, 0.1);
    cancelled.progress = [](const Progress& p) { return p.iteration < 2; };
    EXPECT_EQ(newton(limited, cancelled).run.stop, Stop::kCancelled);
    PlainObjective there(bowl, VectorXd::Ones(4), 1);
    EXPECT_EQ(newton(there, options(0, 1)).run.stop, Stop::kConverged);
    PlainObjective noisy(
        [](const VectorXd& x, Evaluation& e) {
            bowl(x, e);
            e.value += 100;
            e.residual += 0.5;
            return true;
        },
        VectorXd::Zero(8), 1);
    EXPECT_EQ(newton(noisy, options(0.1, 10)).run.stop, Stop::kStalled);
}

TEST(Newton, ReportsThePointThatItReached) {
    for (const int limit : {0, 1, 4, -1}) {
        PlainObjective objective(valley, Eigen::Vector2d(-1.2, 1), 1);
        OptimizerOptions limited = options(1e-2, 0.5);
        limited.max_iterations = limit;
        const OptimizerResult result = newton(objective, limited);
        Evaluation there;
        valley(objective.point(), there);
        EXPECT_EQ(result.evaluation.value, there.value);
        EXPECT_EQ(result.evaluation.gradient, there.gradient);
    }
}

/// The stiffness matrix of a chain of n pairs on springs; only the first pair is fixed, with
/// stiffness `hold`.
BlockMatrix chain_matrix(int n, double hold) {
    BlockMatrix h;
    std::vector<int> n_entries(static_cast<std::size_t>(n), 2);
    n_entries.front() = n_entries.back() = 1;
    h.resize(n_entries);
    for (int i = 0; i < n; ++i) {
        h.diagonal[i] = {double(n_entries[i]), 0.5, 0.5, double(n_entries[i])};
        int entry = h.row_begin[i];
        for (const int j : {i - 1, i + 1}) {
            if (j < 0 || j >= n) continue;
            h.column[entry] = j;
            h.block[entry++] = {-1, 0, 0, -1};
        }
    }
    h.diagonal[0][0] += hold;
    h.diagonal[0][3] += hold;
    return h;
}

TEST(ConjugateGradients, SolveTheSystemToTheGivenResidual) {
    BlockMatrix h = chain_matrix(50, 1);
    for (auto& block : h.diagonal) block[1] = block[2] = 0.01;
    for (auto& block : h.diagonal) block[0] += 0.1, block[3] += 0.1;
    const VectorXd g = VectorXd::LinSpaced(100, -1, 3).array().sin();
    Workers workers(1);
    ConjugateGradients cg(100, workers);
    const auto outcome = cg.solve(h, g, {1e-10, 1e6, 1000});
    EXPECT_FALSE(outcome.truncated);
    VectorXd product(100);
    const double curvature = h.multiply(cg.solution(), product, workers);
    EXPECT_LT((product + g).norm(), 1e-8 * g.norm());
    EXPECT_NEAR(outcome.model / (g.dot(cg.solution()) + curvature / 2), 1, 1e-10);
}

// With negative curvature, and where the solution lies outside, the iteration ends on the boundary,
// below the value at the origin.
TEST(ConjugateGradients, EndAtTheBoundary) {
    const VectorXd g = VectorXd::LinSpaced(100, -1, 3).array().sin();
    Workers workers(1);
    ConjugateGradients cg(100, workers);
    for (const double hold : {1.0, -20.0}) {
        const BlockMatrix h = chain_matrix(50, hold);
        const auto outcome = cg.solve(h, g, {1e-10, 0.3, 1000});
        EXPECT_TRUE(outcome.truncated);
        EXPECT_NEAR(outcome.largest_move, 0.3, 1e-10);
        EXPECT_NEAR(cg.solution().reshaped(2, 50).colwise().norm().maxCoeff(), 0.3, 1e-10);
        VectorXd product(100);
        const double curvature = h.multiply(cg.solution(), product, workers);
        EXPECT_NEAR(outcome.model / (g.dot(cg.solution()) + curvature / 2), 1, 1e-10);
        EXPECT_LT(outcome.model, 0);
    }
}

}  // namespace
}  // namespace pcvt
