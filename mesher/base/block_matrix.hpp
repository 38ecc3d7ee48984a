#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "mesher/base/workers.hpp"

namespace pcvt {

/// A symmetric sparse matrix of 2 x 2 blocks; row i belongs to the variables (x_2i, x_2i+1).
///
/// Each row stores its diagonal block separately. Its other blocks follow each other in any order;
/// a column may occur more than once in a row, and the blocks of equal columns add up. Both
/// triangles of the matrix are stored, so that each row of a product is computed independently.
///
/// Example usage (the Laplacian of two coupled rows):
///
///     BlockMatrix a;
///     a.resize({1, 1});  // one block beside the diagonal in each row
///     a.diagonal = {{1, 0, 0, 1}, {1, 0, 0, 1}};
///     a.column = {1, 0};
///     a.block = {{-1, 0, 0, -1}, {-1, 0, 0, -1}};
///     const double xy = a.multiply(x, y, workers);
struct BlockMatrix {
    /// Entries (0, 0), (1, 0), (0, 1), (1, 1). Off-diagonal blocks are in single precision, because
    /// the product with a large matrix is limited by memory bandwidth.
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
    /// Allocates n_entries[i] off-diagonal blocks in row i.
    void resize(const std::vector<int>& n_entries);
    /// Computes y = A x, bit for bit the same for any number of workers; y must have the size of x.
    double multiply(const Eigen::VectorXd& x, Eigen::VectorXd& y, Workers& workers) const;
};

}  // namespace pcvt
