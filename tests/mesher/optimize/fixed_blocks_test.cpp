#include "mesher/optimize/fixed_blocks.hpp"

#include <gtest/gtest.h>

#include <random>

#include "mesher/base/block_matrix.hpp"
#include "tests/support/dense.hpp"

namespace pcvt {
namespace {

/// A symmetric matrix with blocks between all rows.
BlockMatrix random_matrix(int n, std::mt19937_64& random) {
    std::normal_distribution<float> normal;
    const Eigen::MatrixXf a =
        Eigen::MatrixXf::NullaryExpr(2 * n, 2 * n, [&] { return normal(random); });
    const Eigen::MatrixXf symmetric = a + a.transpose();
    BlockMatrix matrix;
    matrix.resize(std::vector<int>(static_cast<std::size_t>(n), n - 1));
    matrix.annihilates_translations = true;
    for (int i = 0; i < n; ++i) {
        int next = matrix.row_begin[i];
        for (int j = 0; j < n; ++j) {
            const Eigen::Matrix2f block = symmetric.block<2, 2>(2 * i, 2 * j);
            if (i == j) {
                std::copy_n(block.data(), 4, matrix.diagonal[i].begin());
            } else {
                matrix.column[next] = j;
                std::copy_n(block.data(), 4, matrix.block[next++].begin());
            }
        }
    }
    return matrix;
}

TEST(FixedBlocks, RestrictTheHessianToFreePairs) {
    std::mt19937_64 random(1);
    for (int n = 1; n < 9; ++n) {
        std::vector<bool> is_fixed(static_cast<std::size_t>(n), false);
        Eigen::VectorXd free = Eigen::VectorXd::Ones(2 * n);
        for (int i = 0; i < n; ++i) {
            is_fixed[i] = random() % 2 == 0;
            if (is_fixed[i]) free.segment<2>(2 * i).setZero();
        }
        BlockMatrix matrix = random_matrix(n, random);
        const Eigen::MatrixXd all = testing::dense(matrix);
        const FixedBlocks fixed(is_fixed);
        fixed.restrict_hessian(matrix);
        Eigen::MatrixXd expected = free.asDiagonal() * all * free.asDiagonal();
        expected.diagonal() += Eigen::VectorXd::Ones(2 * n) - free;
        EXPECT_EQ(testing::dense(matrix), expected);
        EXPECT_EQ(matrix.annihilates_translations, free.minCoeff() == 1);
    }
}

TEST(FixedBlocks, ClearTheirEntriesAlone) {
    const FixedBlocks fixed({false, true, false});
    Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(6, 1, 6);
    fixed.clear(x);
    EXPECT_EQ(x, (Eigen::VectorXd(6) << 1, 2, 0, 0, 5, 6).finished());
    EXPECT_DOUBLE_EQ(fixed.rms_factor(), std::sqrt(1.5));
    EXPECT_EQ(FixedBlocks().rms_factor(), 1);
    const FixedBlocks in_space({false, true}, 4);
    Eigen::VectorXd y = Eigen::VectorXd::LinSpaced(8, 1, 8);
    in_space.clear(y);
    EXPECT_EQ(y, (Eigen::VectorXd(8) << 1, 2, 3, 4, 0, 0, 0, 0).finished());
    EXPECT_DOUBLE_EQ(in_space.rms_factor(), std::sqrt(2));
    EXPECT_EQ(FixedBlocks({true, true}).rms_factor(), 1);
}

}  // namespace
}  // namespace pcvt
