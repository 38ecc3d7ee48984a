#pragma once

#include <gtest/gtest.h>

#include <utility>

#include "mesher/objective.hpp"

namespace pcvt::testing {

/// An objective whose point is a vector: value, gradient and residuals are a function of it, and
/// the Lloyd step goes against the gradient.
class PlainObjective final : public Objective {
   public:
    using Function = std::function<bool(const Eigen::VectorXd& x, Evaluation& evaluation)>;

    /// @param rate  the Lloyd step over minus the gradient.
    PlainObjective(Function function, Eigen::VectorXd start, double rate)
        : function_(std::move(function)),
          rate_(rate),
          point_(std::move(start)),
          evaluated_(point_) {}

    const Eigen::VectorXd& point() const { return point_; }
    int n_evaluations() const { return n_evaluations_; }

    Eigen::Index n_variables() const override { return point_.size(); }
    bool evaluate(const Eigen::VectorXf& direction, double t, Evaluation& evaluation) override {
        ++n_evaluations_;
        evaluated_ = point_;
        looked_at_point_ = t == 0;
        if (t != 0) evaluated_ += t * direction.cast<double>();
        return function_(evaluated_, evaluation);
    }
    void accept() override {
        point_ = evaluated_;
        looked_at_point_ = true;
    }
    void lloyd_step(const Evaluation& evaluation, Eigen::VectorXf& direction) const override {
        EXPECT_TRUE(looked_at_point_) << "the last look was at a trial";
        direction = (-rate_ * evaluation.gradient).cast<float>();
    }

   private:
    Function function_;
    double rate_;
    Eigen::VectorXd point_;
    Eigen::VectorXd evaluated_;
    bool looked_at_point_ = true;
    int n_evaluations_ = 0;
};

}  // namespace pcvt::testing
