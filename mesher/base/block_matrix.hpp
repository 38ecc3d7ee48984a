#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "mesher/base/workers.hpp"

namespace pcvt {

/// A symmetric matrix of 2 x 2 blocks, sparse: row i belongs to the pair of variables (x_2i,
/// x_2i+1).
///
/// Of a row the diagonal block is stored apart, the others one after the other, in any order; a
/// column may occur more than once in it, and its blocks add up. Both triangles are stored, so that
/// each row of a product is computed on its own.
struct BlockMatrix {
    /// (0, 0), (1, 0), (0, 1), (1, 1). Beside the diagonal in single precision: of large matrices a
    /// product waits for memory.
    using DiagonalBlock = std::array<double, 4>;
    using Block = std::array<float, 4>;

    std::vector<DiagonalBlock> diagonal;
    /// Entries row_begin[i] ... row_begin[i + 1] - 1 belong to row i.
    std::vector<int> row_begin;
    std::vector<int> column;
    std::vector<Block> block;
    /// Whether (1, 0, 1, 0, ...) and (0, 1, 0, 1, ...) are null vectors.
    bool annihilates_translations = false;

    int n_rows() const { return static_cast<int>(diagonal.size()); }
    /// Makes room for rows of these lengths; n_entries[i] blocks in row i beside the diagonal.
    void resize(const std::vector<int>& n_entries);
    /// y = A x for the same bits with any number of workers; y has the size of x.
    /// @returns x.y
    double multiply(const Eigen::VectorXd& x, Eigen::VectorXd& y, Workers& workers) const;
};

}  // namespace pcvt
