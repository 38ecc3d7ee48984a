// The hierarchy of LaplacianSolver: which rows of a level are merged, and into what.

#include <algorithm>

#include "mesher/base/checkpoint.hpp"
#include "mesher/cells/laplacian_solver.hpp"

namespace pcvt {
namespace {

/// A pair of rows so much more strongly coupled to each other than to all others is merged first,
/// and with no second pair at once: sweeps hardly change its mean, which needs a coarse row.
constexpr double kBoundPair = 256;

}  // namespace

namespace {

template <class Matrix>
void finish(Matrix& matrix) {
    matrix.inverse_diagonal.resize(static_cast<std::size_t>(matrix.n_rows()));
    for (int row = 0; row < matrix.n_rows(); ++row) {
        double sum = 0;
        for (int k = matrix.row_begin[row]; k < matrix.row_begin[row + 1]; ++k) {
            sum += double(matrix.conductance[k]);
        }
        matrix.inverse_diagonal[row] = sum > 0 ? 1 / sum : 0;
    }
}

}  // namespace

LaplacianSolver::Matrix LaplacianSolver::matrix_of(const CellGraph& graph) {
    Matrix matrix{.row_begin = graph.row_begin,
                  .column = {graph.neighbour.begin(), graph.neighbour.end()},
                  .conductance = {},
                  .inverse_diagonal = {}};
    matrix.conductance.reserve(graph.conductance.size());
    for (const double c : graph.conductance) matrix.conductance.push_back(static_cast<float>(c));
    finish(matrix);
    return matrix;
}

/// The other row of a bound pair, or -1.
int LaplacianSolver::bound_partner(const Matrix& matrix, int row) {
    int partner = -1;
    float strongest = 0;
    for (int k = matrix.row_begin[row]; k < matrix.row_begin[row + 1]; ++k) {
        if (matrix.conductance[k] <= strongest) continue;
        strongest = matrix.conductance[k];
        partner = matrix.column[k];
    }
    const double others = 1 - double(strongest) * matrix.inverse_diagonal[row];
    return kBoundPair * others < 1 ? partner : -1;
}

/// Merges a row without a partner with the pair of the neighbour of the largest conductance.
void LaplacianSolver::join_neighbour(const Matrix& matrix, int row, std::vector<int>& pair,
                                     int& n_pairs) {
    int neighbour = -1;
    float strongest = 0;
    for (int k = matrix.row_begin[row]; k < matrix.row_begin[row + 1]; ++k) {
        if (matrix.conductance[k] <= strongest || pair[matrix.column[k]] < 0) continue;
        strongest = matrix.conductance[k];
        neighbour = matrix.column[k];
    }
    pair[row] = neighbour >= 0 ? pair[neighbour] : n_pairs++;
}

/// Pairs bound pairs first, then each row with the remaining neighbour of the largest conductance;
/// rows without a remaining neighbour join that of the largest conductance.
/// @param single  rows that get no partner; empty: none.
std::vector<int> LaplacianSolver::match_pairs(const Matrix& matrix, const std::vector<bool>& single,
                                              int& n_pairs) {
    std::vector<int> pair(static_cast<std::size_t>(matrix.n_rows()), -1);
    const auto is_single = [&](int row) { return !single.empty() && single[std::size_t(row)]; };
    n_pairs = 0;
    for (int row = 0; row < matrix.n_rows(); ++row) {
        const int partner = is_single(row) ? -1 : bound_partner(matrix, row);
        if (partner < row || is_single(partner) || bound_partner(matrix, partner) != row) continue;
        pair[row] = pair[partner] = n_pairs++;
    }
    std::vector<int> left;
    for (int row = 0; row < matrix.n_rows(); ++row) {
        checkpoint_each(row);
        if (pair[row] >= 0) continue;
        int partner = -1;
        float strongest = 0;
        for (int k = matrix.row_begin[row]; k < matrix.row_begin[row + 1] && !is_single(row); ++k) {
            if (pair[matrix.column[k]] >= 0 || matrix.conductance[k] <= strongest) continue;
            if (is_single(matrix.column[k])) continue;
            strongest = matrix.conductance[k];
            partner = matrix.column[k];
        }
        if (partner < 0 && !is_single(row)) {
            left.push_back(row);
            continue;
        }
        pair[row] = n_pairs;
        if (partner >= 0) pair[partner] = n_pairs;
        ++n_pairs;
    }
    for (const int row : left) join_neighbour(matrix, row, pair, n_pairs);
    return pair;
}

/// The pairs that kBoundPair keeps single.
/// @param pair_of  the pair of each row of `fine`.
/// @param pairs    the matrix of the pairs.
std::vector<bool> LaplacianSolver::bound_pairs(const Matrix& fine, const std::vector<int>& pair_of,
                                               const Matrix& pairs) {
    std::vector<double> inner(static_cast<std::size_t>(pairs.n_rows()), 0);
    for (int row = 0; row < fine.n_rows(); ++row) {
        const int pair = pair_of[row];
        for (int k = fine.row_begin[row]; k < fine.row_begin[row + 1]; ++k) {
            if (pair_of[fine.column[k]] == pair) inner[pair] += double(fine.conductance[k]);
        }
    }
    std::vector<bool> bound;
    for (int pair = 0; pair < pairs.n_rows(); ++pair) {
        bound.push_back(inner[pair] * pairs.inverse_diagonal[pair] > 2 * kBoundPair);
    }
    return bound;
}

/// Adds up the rows and columns of each aggregate.
LaplacianSolver::Matrix LaplacianSolver::merged(const Matrix& fine,
                                                const std::vector<int>& aggregate, int n_coarse) {
    // Sort the rows by aggregate.
    std::vector<int> begin(static_cast<std::size_t>(n_coarse) + 1, 0);
    for (const int a : aggregate) ++begin[a + 1];
    for (int a = 0; a < n_coarse; ++a) begin[a + 1] += begin[a];
    std::vector<int> members(aggregate.size());
    std::vector<int> next(begin.begin(), begin.end() - 1);
    for (int row = 0; row < fine.n_rows(); ++row) members[next[aggregate[row]]++] = row;
    // Add up the entries; `place` is the entry of a column in the current row.
    Matrix coarse;
    coarse.column.reserve(fine.column.size() / 2);
    coarse.conductance.reserve(fine.column.size() / 2);
    std::vector<int> place(static_cast<std::size_t>(n_coarse), -1);
    for (int a = 0; a < n_coarse; ++a) {
        checkpoint_each(a);
        const int row_begin = coarse.row_begin.back();
        for (int m = begin[a]; m < begin[a + 1]; ++m) {
            const int row = members[m];
            for (int k = fine.row_begin[row]; k < fine.row_begin[row + 1]; ++k) {
                const int column = aggregate[fine.column[k]];
                if (column == a) continue;
                if (place[column] < row_begin) {
                    place[column] = static_cast<int>(coarse.column.size());
                    coarse.column.push_back(column);
                    coarse.conductance.push_back(0);
                }
                coarse.conductance[place[column]] += fine.conductance[k];
            }
        }
        coarse.row_begin.push_back(static_cast<int>(coarse.column.size()));
    }
    finish(coarse);
    return coarse;
}

}  // namespace pcvt
