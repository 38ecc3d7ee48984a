#pragma once

#include "mesher/base/block_matrix.hpp"

namespace pcvt {

/// Minimises the model m(d) = g.d + d.H d / 2 by conjugate gradients, cut short (T. Steihaug 1983):
/// at a relative residual of H d = -g, at the boundary of a trust region in which no pair (d_2i,
/// d_2i+1) is longer than a radius, or, where a direction of negative curvature shows that H is not
/// positive definite, at the boundary along that direction. Preconditioned by the diagonal blocks.
///
/// d.g < 0 and m(d) < 0 unless g = 0. The same bits for any number of workers.
class ConjugateGradients {
   public:
    ConjugateGradients(Eigen::Index n_variables, Workers& workers);

    struct Limits {
        /// Of the residual, in the norm of the preconditioner, over that of g.
        double relative_residual;
        double radius;
        int products;
    };
    struct Outcome {
        /// Products with H.
        int products;
        /// Whether the trust region cut it short.
        bool truncated;
        /// m(d)
        double model;
        /// The largest |(d_2i, d_2i+1)|.
        double largest_move;
    };
    /// Fills solution().
    Outcome solve(const BlockMatrix& h, const Eigen::VectorXd& gradient, const Limits& limits);
    const Eigen::VectorXd& solution() const { return solution_; }

   private:
    struct Sums;
    template <class Task>
    Sums sweep(const Task& task);
    Eigen::Vector2d preconditioned(Eigen::Index i) const;
    double start(const BlockMatrix& h, const Eigen::VectorXd& gradient);
    bool truncated_run(const BlockMatrix& h, const Limits& limits, double rz, int& products);
    Sums advance(double alpha);
    void turn(double beta);
    double longest_step(double radius);
    void remove_mean();

    Workers& workers_;
    Eigen::VectorXd solution_;
    Eigen::VectorXd residual_;
    Eigen::VectorXd direction_;
    Eigen::VectorXd product_;
    std::vector<BlockMatrix::Block> preconditioner_;
};

}  // namespace pcvt
