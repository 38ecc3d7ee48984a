#include "mesher/block_matrix.hpp"

#include <algorithm>

namespace pcvt {
namespace {

constexpr int kRowsPerTask = 1 << 13;

/// Rows begin ... end - 1 of y = A x; returns their part of x.y.
double multiply_rows(const BlockMatrix& a, const double* x, double* y, int begin, int end) {
    using Pair = Eigen::Vector2d;
    using Pairs = Eigen::Map<const Pair>;
    double dot = 0;
    for (int i = begin; i < end; ++i) {
        const double* own = a.diagonal[i].data();
        const Pair at(Pairs(x + 2 * std::size_t(i)));
        Pair sum = Pairs(own) * at[0] + Pairs(own + 2) * at[1];
        for (int k = a.row_begin[i]; k < a.row_begin[i + 1]; ++k) {
            const double* there = x + 2 * std::size_t(a.column[k]);
            const double* block = a.block[k].data();
            sum += Pairs(block) * there[0] + Pairs(block + 2) * there[1];
        }
        Eigen::Map<Pair>(y + 2 * std::size_t(i)) = sum;
        dot += at.dot(sum);
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
