#include "mesher/base/block_matrix.hpp"

#include <algorithm>

#include "mesher/base/target_clones.hpp"

namespace pcvt {
namespace {

constexpr int kRowsPerTask = 1 << 13;

/// Computes rows begin ... end - 1 of y = A x; returns their contribution to x.y.
PCVT_TARGET_CLONES double multiply_rows(const BlockMatrix& a, const double* x, double* y, int begin,
                                        int end) {
    double dot = 0;
    for (int i = begin; i < end; ++i) {
        const double* at = x + 2 * std::size_t(i);
        double sum[4];
        for (int m = 0; m < 4; ++m) sum[m] = a.diagonal[i][m] * at[m / 2];
        for (int k = a.row_begin[i]; k < a.row_begin[i + 1]; ++k) {
            const double* there = x + 2 * std::size_t(a.column[k]);
            const float* block = a.block[k].data();
            for (int m = 0; m < 4; ++m) sum[m] += double(block[m]) * there[m / 2];
        }
        y[2 * std::size_t(i)] = sum[0] + sum[2];
        y[2 * std::size_t(i) + 1] = sum[1] + sum[3];
        dot += at[0] * (sum[0] + sum[2]) + at[1] * (sum[1] + sum[3]);
    }
    return dot;
}

}  // namespace

void BlockMatrix::resize(const std::vector<int>& n_entries) {
    diagonal.resize(n_entries.size());
    row_begin.resize(n_entries.size() + 1);
    row_begin[0] = 0;
    for (std::size_t i = 0; i < n_entries.size(); ++i)
        row_begin[i + 1] = row_begin[i] + n_entries[i];
    column.resize(static_cast<std::size_t>(row_begin.back()));
    block.resize(column.size());
}

double BlockMatrix::multiply(const Eigen::VectorXd& x, Eigen::VectorXd& y, Workers& workers) const {
    const int n_tasks = (n_rows() + kRowsPerTask - 1) / kRowsPerTask;
    std::vector<double> dots(static_cast<std::size_t>(n_tasks));
    workers.for_each(n_tasks, [&](int task) {
        const int begin = task * kRowsPerTask;
        const int end = std::min(begin + kRowsPerTask, n_rows());
        dots[task] = multiply_rows(*this, x.data(), y.data(), begin, end);
    });
    double dot = 0;
    for (const double part : dots) dot += part;
    return dot;
}

}  // namespace pcvt
