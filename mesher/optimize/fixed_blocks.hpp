#pragma once

#include <Eigen/Core>
#include <cmath>
#include <vector>

namespace pcvt {

struct BlockMatrix;

/// Blocks of variables, those of one site each, that an objective holds fixed. With E the embedding
/// of the other variables, gradients become E E^T g and Hessians E E^T H E E^T + the identity on
/// fixed blocks, so that optimisers, whose directions are combinations of gradients, never move a
/// fixed block: not by one bit.
///
/// Example usage (within Objective::evaluate):
///
///     fixed_.clear(evaluation.gradient);
///     evaluation.rms_residual *= fixed_.rms_factor();
class FixedBlocks {
   public:
    /// Fixes none.
    FixedBlocks() = default;
    /// @param is_fixed  one entry for each block.
    /// @param size      the number of variables in a block.
    explicit FixedBlocks(std::vector<bool> is_fixed, int size = 2);

    /// One entry for each block, or none if no block is fixed.
    const std::vector<bool>& is_fixed() const { return is_fixed_; }
    /// Sets the fixed entries of a vector to zero.
    template <class Vector>
    void clear(Vector& x) const {
        for (const Eigen::Index block : fixed_) x.segment(size_ * block, size_).setZero();
    }
    /// The root mean square over free blocks divided by that over all blocks, if fixed ones are
    /// zero.
    double rms_factor() const { return rms_factor_; }
    /// Replaces rows and columns of fixed blocks, which must be pairs, with those of the
    /// identity.
    void restrict_hessian(BlockMatrix& hessian) const;

   private:
    Eigen::Index size_ = 2;
    std::vector<bool> is_fixed_;
    std::vector<Eigen::Index> fixed_;
    double rms_factor_ = 1;
};

}  // namespace pcvt
