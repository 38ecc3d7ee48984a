#pragma once

#include <gtest/gtest.h>

#include <utility>

#include "mesher/base/block_matrix.hpp"
#include "mesher/optimize/objective.hpp"

namespace pcvt::testing {

/// An objective whose point is a vector: value, gradient and residuals are a function of it, and
/// the Lloyd step is a gradient step. Expects that the optimiser accepts or rejects every trial,
/// and that the trial's direction does not change until then.
class PlainObjective final : public Objective {
   public:
    using Function = std::function<bool(const Eigen::VectorXd& x, Evaluation& evaluation)>;

    /// @param rate  the ratio of the Lloyd step to minus the gradient.
    PlainObjective(Function function, Eigen::VectorXd start, double rate)
        : function_(std::move(function)),
          rate_(rate),
          point_(std::move(start)),
          evaluated_(point_) {}
    ~PlainObjective() override {
        EXPECT_EQ(trial_, nullptr) << "a trial was neither accepted nor rejected";
    }
    PlainObjective(const PlainObjective&) = delete;
    PlainObjective& operator=(const PlainObjective&) = delete;

    /// Applies `change` to each Hessian before the optimiser receives it.
    void mislead_hessian(std::function<void(BlockMatrix&)> change) {
        change_hessian_ = std::move(change);
    }

    const Eigen::VectorXd& point() const { return point_; }
    int n_evaluations() const { return n_evaluations_; }

    Eigen::Index n_variables() const override { return point_.size(); }
    bool evaluate(const Eigen::VectorXf& direction, double t, Evaluation& evaluation) override {
        ++n_evaluations_;
        close_trial();
        if (t != 0) {
            trial_ = &direction;
            trial_direction_ = direction;
        }
        evaluated_ = point_;
        evaluated_at_point_ = t == 0;
        if (t != 0) evaluated_ += t * direction.cast<double>();
        return function_(evaluated_, evaluation);
    }
    void accept() override {
        close_trial();
        point_ = evaluated_;
        evaluated_at_point_ = true;
    }
    void reject() override { close_trial(); }
    bool has_hessian() const override { return has_hessian_; }
    void forget_hessian() { has_hessian_ = false; }
    /// Computes the Hessian by differences of the gradient; stores all blocks of each row.
    void hessian(BlockMatrix& hessian) const override;
    void lloyd_step(const Evaluation& evaluation, Eigen::VectorXf& direction) const override {
        EXPECT_TRUE(evaluated_at_point_) << "the last evaluation was at a trial";
        direction = (-rate_ * evaluation.gradient).cast<float>();
    }

   private:
    static constexpr double kDifference = 1e-6;

    void close_trial() {
        if (trial_ != nullptr) {
            EXPECT_EQ(*trial_, trial_direction_);
        }
        trial_ = nullptr;
    }

    Eigen::VectorXd gradient_at(const Eigen::VectorXd& x) const {
        Evaluation evaluation;
        function_(x, evaluation);
        return evaluation.gradient;
    }

    Function function_;
    std::function<void(BlockMatrix&)> change_hessian_;
    bool has_hessian_ = true;
    double rate_;
    Eigen::VectorXd point_;
    Eigen::VectorXd evaluated_;
    bool evaluated_at_point_ = true;
    int n_evaluations_ = 0;
    const Eigen::VectorXf* trial_ = nullptr;
    Eigen::VectorXf trial_direction_;
};

inline void PlainObjective::hessian(BlockMatrix& hessian) const {
    EXPECT_TRUE(evaluated_at_point_) << "the last evaluation was at a trial";
    const auto n_rows = static_cast<int>(point_.size() / 2);
    hessian.resize(std::vector<int>(static_cast<std::size_t>(n_rows), n_rows - 1));
    for (int j = 0; j < n_rows; ++j) {
        Eigen::MatrixX2d columns(point_.size(), 2);
        for (int k = 0; k < 2; ++k) {
            const Eigen::VectorXd e = kDifference * Eigen::VectorXd::Unit(point_.size(), 2 * j + k);
            columns.col(k) =
                (gradient_at(point_ + e) - gradient_at(point_ - e)) / (2 * kDifference);
        }
        for (int i = 0; i < n_rows; ++i) {
            const Eigen::Matrix2d block = columns.middleRows<2>(2 * i);
            const int entry = hessian.row_begin[i] + (j < i ? j : j - 1);
            if (i == j) std::copy_n(block.data(), 4, hessian.diagonal[i].begin());
            if (i == j) continue;
            hessian.column[entry] = j;
            Eigen::Map<Eigen::Matrix2f>(hessian.block[entry].data()) = block.cast<float>();
        }
    }
    if (change_hessian_) change_hessian_(hessian);
}

}  // namespace pcvt::testing
