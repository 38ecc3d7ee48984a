#include "mesher/optimize/lbfgs_newton.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/plain_objective.hpp"

namespace pcvt {
namespace {

using Eigen::VectorXd;
using testing::PlainObjective;

/// The sum of cosh(k x_k): minimum at 0, where Newton's method is superlinear.
bool cosh_sum(const VectorXd& x, Evaluation& e) {
    const VectorXd weight = VectorXd::LinSpaced(x.size(), 1, double(x.size()));
    const VectorXd kx = weight.cwiseProduct(x);
    e.value = kx.array().cosh().sum();
    e.gradient = weight.array() * kx.array().sinh();
    e.residual = e.gradient.cwiseAbs().maxCoeff() / double(x.size());
    e.rms_residual = e.gradient.norm() / (double(x.size()) * std::sqrt(double(x.size())));
    return true;
}

PlainObjective from(double start) { return {cosh_sum, VectorXd::Constant(20, start), 1.0 / 400}; }

OptimizerResult lbfgs_newton(Objective& objective, double tolerance, NewtonStart start,
                             const ProgressCallback& progress = {}) {
    Workers workers(1);
    return minimize_lbfgs_newton(objective, {tolerance, -1, 0.5, progress}, start, workers);
}

TEST(LbfgsNewton, UsesLbfgsAloneFarFromAMinimum) {
    PlainObjective objective = from(0.3);
    const OptimizerResult loose = lbfgs_newton(objective, 1e-2, NewtonStart::kNear);
    EXPECT_EQ(loose.run.stop, Stop::kConverged);
    EXPECT_EQ(loose.run.hessians, 0);
    PlainObjective again = from(0.3);
    EXPECT_GT(lbfgs_newton(again, 1e-2, NewtonStart::kAtOnce).run.hessians, 0);
}

TEST(LbfgsNewton, UsesLbfgsAloneWithoutAHessian) {
    PlainObjective objective = from(0.3);
    objective.forget_hessian();
    const OptimizerResult result = lbfgs_newton(objective, 1e-9, NewtonStart::kAtOnce);
    EXPECT_EQ(result.run.stop, Stop::kConverged);
    EXPECT_EQ(result.run.hessians, 0);
    EXPECT_EQ(result.run.evaluations, objective.n_evaluations());
}

TEST(LbfgsNewton, FinishesByNewtonAndStartsWithNewtonNearAMinimum) {
    PlainObjective far = from(0.3);
    const OptimizerResult finished = lbfgs_newton(far, 1e-12, NewtonStart::kNear);
    EXPECT_EQ(finished.run.stop, Stop::kConverged);
    EXPECT_GT(finished.run.hessians, 0);
    EXPECT_GT(finished.run.iterations, finished.run.hessians);
    PlainObjective near = from(1e-3);
    const OptimizerResult at_once = lbfgs_newton(near, 1e-12, NewtonStart::kNear);
    EXPECT_EQ(at_once.run.stop, Stop::kConverged);
    EXPECT_EQ(at_once.run.iterations, at_once.run.hessians);
}

// Iterations are reported one by one, and the evaluations match the objective's count.
TEST(LbfgsNewton, CountsOverAllLegs) {
    for (const NewtonStart start : {NewtonStart::kNear, NewtonStart::kAtOnce}) {
        PlainObjective objective = from(0.3);
        int next = 0;
        const OptimizerResult result =
            lbfgs_newton(objective, 1e-12, start, [&](const Progress& p) {
                EXPECT_EQ(p.iteration, next++);
                EXPECT_EQ(p.evaluations, objective.n_evaluations());
                return true;
            });
        EXPECT_EQ(result.run.iterations + 1, next);
        EXPECT_EQ(result.run.evaluations, objective.n_evaluations());
        Evaluation there;
        cosh_sum(objective.point(), there);
        EXPECT_EQ(result.evaluation.value, there.value);
    }
}

TEST(LbfgsNewton, StopsAtLimitsAndCancellationsInEveryLeg) {
    for (const NewtonStart start : {NewtonStart::kNear, NewtonStart::kAtOnce}) {
        PlainObjective whole = from(0.3);
        const int n_iterations = lbfgs_newton(whole, 1e-12, start).run.iterations;
        for (int limit = 0; limit <= n_iterations; ++limit) {
            PlainObjective objective = from(0.3);
            Workers workers(1);
            const auto limited =
                minimize_lbfgs_newton(objective, {1e-12, limit, 0.5, {}}, start, workers);
            EXPECT_EQ(limited.run.iterations, limit);
            EXPECT_EQ(limited.run.stop == Stop::kConverged, limit == n_iterations) << limit;
            PlainObjective another = from(0.3);
            const auto cancelled = lbfgs_newton(
                another, 1e-12, start, [limit](const Progress& p) { return p.iteration < limit; });
            EXPECT_EQ(cancelled.run.stop, Stop::kCancelled);
            EXPECT_EQ(cancelled.run.iterations, limit);
        }
    }
}

// Beyond double precision Newton's method gets stuck first, then L-BFGS.
TEST(LbfgsNewton, StallsWhereBothMethodsStall) {
    for (const NewtonStart start : {NewtonStart::kNear, NewtonStart::kAtOnce}) {
        PlainObjective objective(
            [](const VectorXd& x, Evaluation& e) {
                cosh_sum(x, e);
                e.residual += 1e-3;
                return true;
            },
            VectorXd::Constant(20, 0.3), 1.0 / 400);
        EXPECT_EQ(lbfgs_newton(objective, 1e-6, start).run.stop, Stop::kStalled);
    }
}

// Where Newton's method makes no progress, L-BFGS still converges.
TEST(LbfgsNewton, ContinuesWithLbfgsWhereNewtonIsStuck) {
    int n_hessians = 0;
    PlainObjective objective = from(0.3);
    objective.mislead_hessian([&](BlockMatrix& h) {
        ++n_hessians;
        for (auto& block : h.diagonal) block = {1e12, 0, 0, 1e12};
        for (auto& block : h.block) block = {};
    });
    const OptimizerResult result = lbfgs_newton(objective, 1e-9, NewtonStart::kNear);
    EXPECT_EQ(result.run.stop, Stop::kConverged);
    EXPECT_EQ(result.run.hessians, n_hessians);
    EXPECT_GT(n_hessians, 0);
}

}  // namespace
}  // namespace pcvt
