#pragma once

#include "mesher/base/block_matrix.hpp"

namespace pcvt {

/// Minimises the quadratic model m(d) = g.d + d.H d / 2 by truncated conjugate gradients (T.
/// Steihaug 1983), preconditioned by the diagonal blocks of H. The iteration ends at a given
/// relative residual of H d = -g, or at the boundary of the trust region, in which no pair (d_2i,
/// d_2i+1) is longer than the radius. A direction of negative curvature, which proves that H is not
/// positive definite, is followed to that boundary.
///
/// The solution satisfies d.g < 0 and m(d) < 0 unless g = 0. It is bit for bit the same for any
/// number of workers.
class ConjugateGradients {
   public:
    ConjugateGradients(Eigen::Index n_variables, Workers& workers);

    struct Limits {
        /// The residual over that of d = 0, both in the norm of the preconditioner.
        double relative_residual;
        /// The radius of the trust region, in the units of d.
        double radius;
        /// Largest number of products with H.
        int products;
    };
    struct Outcome {
        /// Number of products with H.
        int products;
        /// Whether the solution lies on the boundary of the trust region.
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
