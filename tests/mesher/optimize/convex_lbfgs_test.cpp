#include "mesher/optimize/convex_lbfgs.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace pcvt {
namespace {

/// The sum of c_k cosh(x_k - k / n), c_k from 1 to 1e3, defined for |x_k| < 3.
class Valley final : public Objective {
   public:
    explicit Valley(int n) : x_(Eigen::VectorXd::Zero(n)), trial_(x_) {}

    Eigen::Index n_variables() const override { return x_.size(); }
    bool evaluate(const Eigen::VectorXf& d, double t, Evaluation& e) override {
        trial_ = x_;
        if (t != 0) trial_ += t * d.cast<double>();
        if (!(trial_.cwiseAbs().maxCoeff() < 3)) return false;
        e.gradient.resize(x_.size());
        e.value = 0;
        for (Eigen::Index k = 0; k < x_.size(); ++k) {
            const double off = trial_[k] - double(k) / double(x_.size());
            e.value += factor(k) * std::cosh(off);
            e.gradient[k] = factor(k) * std::sinh(off);
        }
        e.residual = e.rms_residual = e.gradient.cwiseAbs().maxCoeff();
        return true;
    }
    void accept() override { x_ = trial_; }
    void lloyd_step(const Evaluation&, Eigen::VectorXf&) const override {}

    double factor(Eigen::Index k) const { return std::pow(1e3, double(k) / double(x_.size() - 1)); }
    const Eigen::VectorXd& x() const { return x_; }

   private:
    Eigen::VectorXd x_;
    Eigen::VectorXd trial_;
};

TEST(MinimizeConvex, FindsTheMinimumOfANarrowValley) {
    for (const int n : {2, 20, 200}) {
        for (const bool has_scales : {false, true}) {
            Valley valley(n);
            Eigen::VectorXd scales = Eigen::VectorXd::Ones(n);
            for (int k = 0; has_scales && k < n; ++k) scales[k] = 1 / valley.factor(k);
            const OptimizerResult result =
                minimize_convex(valley, scales, {.tolerance = 1e-8, .max_move = 0.5});
            EXPECT_EQ(result.run.stop, Stop::kConverged) << n << " " << result.run.residual;
            EXPECT_LT(result.run.evaluations, has_scales ? 20 : 600);
            for (int k = 0; k < n; ++k) EXPECT_NEAR(valley.x()[k], double(k) / n, 1e-8);
        }
    }
}

TEST(MinimizeConvex, EndsAtALimit) {
    Valley valley(20);
    const OptimizerResult result = minimize_convex(valley, Eigen::VectorXd::Constant(20, 1e-6),
                                                   {.max_iterations = 2, .max_move = 0.5});
    EXPECT_EQ(result.run.stop, Stop::kIterationLimit);
    EXPECT_EQ(result.run.iterations, 2);
}

}  // namespace
}  // namespace pcvt
