#pragma once

#include "mesher/base/block_matrix.hpp"

namespace pcvt::testing {

/// Converts a block matrix to a dense matrix.
inline Eigen::MatrixXd dense(const BlockMatrix& h) {
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(2 * h.n_rows(), 2 * h.n_rows());
    const auto add = [&matrix](int i, int j, const auto& block) {
        for (int k = 0; k < 4; ++k) matrix(2 * i + k % 2, 2 * j + k / 2) += block[k];
    };
    for (int i = 0; i < h.n_rows(); ++i) {
        add(i, i, h.diagonal[i]);
        for (int k = h.row_begin[i]; k < h.row_begin[i + 1]; ++k) add(i, h.column[k], h.block[k]);
    }
    return matrix;
}

}  // namespace pcvt::testing
