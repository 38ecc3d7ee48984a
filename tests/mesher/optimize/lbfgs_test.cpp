#include "mesher/optimize/lbfgs.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "mesher/optimize/lloyd.hpp"
#include "tests/support/plain_problems.hpp"

namespace pcvt {
namespace {

using Eigen::VectorXd;
using testing::bowl;
using testing::MoveWatch;
using testing::options;
using testing::PlainObjective;
using testing::valley;

/// A bowl with a safe gradient step in place of Lloyd's.
PlainObjective bowl_from(const VectorXd& start, const PlainObjective::Function& function = bowl) {
    return {function, start, 1 / (4 * double(start.size()))};
}

OptimizerResult lbfgs(Objective& objective, const OptimizerOptions& options) {
    Workers workers(1);
    return minimize_lbfgs(objective, options, workers);
}

TEST(Lbfgs, FindsTheMinimumOfABowlAndOfACurvedValley) {
    PlainObjective in_bowl = bowl_from(VectorXd::Zero(40));
    const auto bowl_result = lbfgs(in_bowl, options(1e-10, 10));
    EXPECT_EQ(bowl_result.run.stop, Stop::kConverged);
    EXPECT_LT((in_bowl.point() - VectorXd::Ones(40)).norm(), 1e-8);
    EXPECT_LT(bowl_result.run.evaluations, 100);
    PlainObjective in_valley(valley, Eigen::Vector2d(-1.2, 1), 1e-3);
    const auto valley_result = lbfgs(in_valley, options(1e-8, 0.5));
    EXPECT_EQ(valley_result.run.stop, Stop::kConverged);
    EXPECT_LT((in_valley.point() - Eigen::Vector2d(1, 1)).norm(), 1e-6);
    EXPECT_LT(valley_result.run.evaluations, 80);
}

TEST(Lbfgs, NeverMovesAPairFurtherThanTheClamp) {
    PlainObjective objective = bowl_from(VectorXd::Constant(10, 50));
    MoveWatch watch(objective);
    EXPECT_EQ(lbfgs(objective, watch.with(options(1e-8, 0.25))).run.stop, Stop::kConverged);
    EXPECT_LE(watch.longest(), 0.25 * (1 + 1e-6));
    EXPECT_GT(watch.longest(), 0.2);
}

TEST(Lbfgs, StepsBackFromWhereTheFunctionIsNotDefined) {
    const auto walled = [](const VectorXd& x, Evaluation& e) {
        return x.maxCoeff() < 1.0005 && bowl(x, e);
    };
    PlainObjective objective = bowl_from(VectorXd::Constant(6, -3), walled);
    EXPECT_EQ(lbfgs(objective, options(1e-9, 2)).run.stop, Stop::kConverged);
    EXPECT_LT((objective.point() - VectorXd::Ones(6)).norm(), 1e-7);
}

// A value that is NaN counts as undefined.
TEST(Lbfgs, StepsBackFromWhereTheValueIsNotANumber) {
    const auto holed = [](const VectorXd& x, Evaluation& e) {
        bowl(x, e);
        if (x.maxCoeff() >= 1.0005) e.value = std::nan("");
        return true;
    };
    PlainObjective objective = bowl_from(VectorXd::Constant(6, -3), holed);
    EXPECT_EQ(lbfgs(objective, options(1e-9, 2)).run.stop, Stop::kConverged);
}

// Where no step along the direction is defined, the history is reset and the Lloyd step is taken.
TEST(Lbfgs, RestartsWithTheLloydStepWhereALineSearchFails) {
    const int n_trials = 25;
    int n_refused = n_trials;
    const auto refusing = [&](const VectorXd& x, Evaluation& e) {
        return n_refused++ >= n_trials && bowl(x, e);
    };
    PlainObjective objective = bowl_from(VectorXd::Zero(40), refusing);
    OptimizerOptions watched = options(1e-10, 10);
    watched.progress = [&](const Progress& p) {
        if (p.iteration == 10) n_refused = 0;
        return true;
    };
    EXPECT_EQ(lbfgs(objective, watched).run.stop, Stop::kConverged);
    EXPECT_GT(n_refused, n_trials);
    EXPECT_LT((objective.point() - VectorXd::Ones(40)).norm(), 1e-8);
}

using Minimize = std::function<OptimizerResult(Objective&, const OptimizerOptions&)>;

/// Expects each reason to stop, for both optimisers.
void expect_stops(const Minimize& minimize) {
    const auto run = [&](const VectorXd& start, const OptimizerOptions& how) {
        PlainObjective objective = bowl_from(start);
        return minimize(objective, how);
    };
    const VectorXd start = VectorXd::Zero(30);
    OptimizerOptions limited = options(1e-10, 10);
    limited.max_iterations = 3;
    const auto limit = run(start, limited);
    EXPECT_EQ(limit.run.stop, Stop::kIterationLimit);
    EXPECT_EQ(limit.run.iterations, 3);

    OptimizerOptions cancelled = options(1e-10, 10);
    cancelled.progress = [](const Progress& p) { return p.iteration < 2; };
    EXPECT_EQ(run(start, cancelled).run.stop, Stop::kCancelled);
    EXPECT_EQ(run(VectorXd::Ones(30), options(0, 10)).run.stop, Stop::kConverged);

    const auto noisy = [](const VectorXd& x, Evaluation& e) {
        bowl(x, e);
        e.value += 100;
        e.residual += 0.5;
        return true;
    };
    PlainObjective stuck = bowl_from(start, noisy);
    EXPECT_EQ(minimize(stuck, options(0.1, 10)).run.stop, Stop::kStalled);
    const auto nowhere = [](const VectorXd&, Evaluation&) { return false; };
    PlainObjective undefined = bowl_from(start, nowhere);
    EXPECT_EQ(minimize(undefined, options(0.1, 10)).run.stop, Stop::kStalled);
    PlainObjective at_start_only = bowl_from(
        start, [&](const VectorXd& x, Evaluation& e) { return bowl(x, e) && x == start; });
    EXPECT_EQ(minimize(at_start_only, options(0.1, 10)).run.stop, Stop::kStalled);
}

TEST(Lbfgs, ReportsWhyItEnded) { expect_stops(lbfgs); }
TEST(Lloyd, ReportsWhyItEnded) { expect_stops(minimize_lloyd); }

/// Expects that the result belongs to the objective's point and counts all its evaluations.
void expect_own_evaluation(const Minimize& minimize) {
    for (const int limit : {0, 1, 4, 17, -1}) {
        PlainObjective objective(valley, Eigen::Vector2d(-1.2, 1), 1e-3);
        OptimizerOptions limited = options(1e-2, 0.5);
        limited.max_iterations = limit;
        const OptimizerResult result = minimize(objective, limited);
        Evaluation there;
        valley(objective.point(), there);
        EXPECT_EQ(result.evaluation.value, there.value);
        EXPECT_EQ(result.evaluation.gradient, there.gradient);
        EXPECT_EQ(result.evaluation.residual, there.residual);
        EXPECT_EQ(result.run.evaluations, objective.n_evaluations());
    }
}

TEST(Lbfgs, ReportsThePointThatItReached) { expect_own_evaluation(lbfgs); }
TEST(Lloyd, ReportsThePointThatItReached) { expect_own_evaluation(minimize_lloyd); }

TEST(Lbfgs, BeginsWithTheLloydStep) {
    const VectorXd start = VectorXd::Constant(8, 3);
    PlainObjective by_lbfgs = bowl_from(start);
    PlainObjective by_lloyd = bowl_from(start);
    OptimizerOptions one_step = options(0, 10);
    one_step.max_iterations = 1;
    lbfgs(by_lbfgs, one_step);
    minimize_lloyd(by_lloyd, one_step);
    const VectorXd step = by_lloyd.point() - start;
    EXPECT_LT((by_lbfgs.point() - by_lloyd.point()).norm(), 1e-4 * step.norm());
}

TEST(Lbfgs, ReachesTheSamePointWithAnyNumberOfWorkers) {
    const VectorXd start = VectorXd::Random(100000);
    VectorXd reached;
    for (const int n_threads : {1, 2, 3}) {
        Workers workers(n_threads);
        PlainObjective objective = bowl_from(start);
        OptimizerOptions limited = options(0, 10);
        limited.max_iterations = 12;
        minimize_lbfgs(objective, limited, workers);
        if (n_threads == 1) reached = objective.point();
        EXPECT_EQ(objective.point(), reached);
    }
}

TEST(Lloyd, FollowsTheFixedPointSteps) {
    PlainObjective objective = bowl_from(VectorXd::Zero(4));
    Evaluation e;
    bowl(objective.point(), e);
    Eigen::VectorXf step;
    objective.lloyd_step(e, step);
    OptimizerOptions one_step = options(0, 10);
    one_step.max_iterations = 1;
    minimize_lloyd(objective, one_step);
    EXPECT_EQ(objective.point(), step.cast<double>());
}

TEST(Lloyd, NeverMovesAPairFurtherThanTheClamp) {
    PlainObjective objective = bowl_from(VectorXd::Constant(10, 50));
    OptimizerOptions one_step = options(0, 0.25);
    one_step.max_iterations = 1;
    minimize_lloyd(objective, one_step);
    const VectorXd move = objective.point() - VectorXd::Constant(10, 50);
    EXPECT_NEAR(move.reshaped(2, 5).colwise().norm().maxCoeff(), 0.25, 1e-6);
}

}  // namespace
}  // namespace pcvt
