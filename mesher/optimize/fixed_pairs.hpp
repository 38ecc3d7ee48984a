#pragma once

#include <Eigen/Core>
#include <cmath>
#include <vector>

namespace pcvt {

struct BlockMatrix;

/// Pairs of variables (x_2i, x_2i+1) that an objective holds fixed. With E the embedding of the
/// other variables, gradients become E E^T g and Hessians E E^T H E E^T + the identity on fixed
/// pairs, so that optimisers, whose directions are combinations of gradients, never move a fixed
/// pair: not by one bit.
///
/// Example usage (within Objective::evaluate):
///
///     fixed_.clear(evaluation.gradient);
///     evaluation.rms_residual *= fixed_.rms_factor();
class FixedPairs {
   public:
    /// Fixes none.
    FixedPairs() = default;
    /// @param is_fixed  one entry for each pair.
    explicit FixedPairs(std::vector<bool> is_fixed);

    /// Sets the fixed entries of a vector to zero.
    template <class Vector>
    void clear(Vector& x) const {
        for (const Eigen::Index pair : fixed_) x.template segment<2>(2 * pair).setZero();
    }
    /// The root mean square over free pairs divided by that over all pairs, if fixed ones are zero.
    double rms_factor() const { return rms_factor_; }
    /// Replaces rows and columns of fixed pairs with those of the identity.
    void restrict_hessian(BlockMatrix& hessian) const;

   private:
    std::vector<bool> is_fixed_;
    std::vector<Eigen::Index> fixed_;
    double rms_factor_ = 1;
};

}  // namespace pcvt
