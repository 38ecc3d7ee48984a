#include "mesher/optimize/fixed_blocks.hpp"

#include "mesher/base/block_matrix.hpp"

namespace pcvt {

FixedBlocks::FixedBlocks(std::vector<bool> is_fixed, int size)
    : size_(size), is_fixed_(std::move(is_fixed)) {
    for (std::size_t i = 0; i < is_fixed_.size(); ++i) {
        if (is_fixed_[i]) fixed_.push_back(static_cast<Eigen::Index>(i));
    }
    const auto n = static_cast<double>(is_fixed_.size());
    const double n_free = n - static_cast<double>(fixed_.size());
    if (n_free > 0) rms_factor_ = std::sqrt(n / n_free);
}

void FixedBlocks::restrict_hessian(BlockMatrix& hessian) const {
    if (fixed_.empty()) return;
    const auto is_kept = [&](int row, int k) {
        return !is_fixed_[row] && !is_fixed_[hessian.column[k]];
    };
    std::vector<int> n_entries(is_fixed_.size(), 0);
    for (int i = 0; i < hessian.n_rows(); ++i) {
        for (int k = hessian.row_begin[i]; k < hessian.row_begin[i + 1]; ++k) {
            n_entries[i] += is_kept(i, k);
        }
    }
    BlockMatrix restricted;
    restricted.resize(n_entries);
    for (int i = 0; i < hessian.n_rows(); ++i) {
        restricted.diagonal[i] =
            is_fixed_[i] ? BlockMatrix::DiagonalBlock{1, 0, 0, 1} : hessian.diagonal[i];
        int next = restricted.row_begin[i];
        for (int k = hessian.row_begin[i]; k < hessian.row_begin[i + 1]; ++k) {
            if (!is_kept(i, k)) continue;
            restricted.column[next] = hessian.column[k];
            restricted.block[next++] = hessian.block[k];
        }
    }
    hessian = std::move(restricted);
}

}  // namespace pcvt
