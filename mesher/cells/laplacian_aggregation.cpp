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

/// Closes the row whose entries have been appended: moves smaller columns to the front.
void LaplacianSolver::finish_row(Level& level) {
    const int row = level.n_rows();
    int lower = level.row_begin[row];
    for (int k = lower; k < std::ssize(level.column); ++k) {
        if (level.column[k] > row) continue;
        std::swap(level.column[k], level.column[lower]);
        std::swap(level.conductance[k], level.conductance[lower++]);
    }
    level.lower_end.push_back(lower);
    level.row_begin.push_back(static_cast<int>(level.column.size()));
}

namespace {

/// The sum of each row; rows without a neighbour get 0, which keeps them out of the solution.
template <class Level>
void invert_diagonal(Level& level) {
    level.inverse_diagonal.resize(level.n_rows());
    for (int row = 0; row < level.n_rows(); ++row) {
        double sum = 0;
        for (int k = level.row_begin[row]; k < level.row_begin[row + 1]; ++k) {
            sum += double(level.conductance[k]);
        }
        level.inverse_diagonal[row] = sum > 0 ? 1 / sum : 0;
    }
}

}  // namespace

LaplacianSolver::Level LaplacianSolver::finest_level(const CellGraph& graph) {
    Level level;
    level.column.reserve(graph.neighbour.size());
    level.conductance.reserve(graph.neighbour.size());
    for (int row = 0; row < graph.n_rows(); ++row) {
        checkpoint_each(row);
        for (int k = graph.row_begin[row]; k < graph.row_begin[row + 1]; ++k) {
            level.column.push_back(graph.neighbour[k]);
            level.conductance.push_back(static_cast<float>(graph.conductance[k]));
        }
        finish_row(level);
    }
    invert_diagonal(level);
    return level;
}

void LaplacianSolver::replace_finest(const CellGraph& graph) {
    Level level = finest_level(graph);
    Level& finest = levels_.front();
    finest.row_begin.swap(level.row_begin);
    finest.lower_end.swap(level.lower_end);
    finest.column.swap(level.column);
    finest.conductance.swap(level.conductance);
    finest.inverse_diagonal.swap(level.inverse_diagonal);
    if (levels_.size() == 1) factorize_coarsest();
}

/// The other row of a bound pair, or -1.
int LaplacianSolver::bound_partner(const Level& level, int row) {
    int partner = -1;
    float strongest = 0;
    for (int k = level.row_begin[row]; k < level.row_begin[row + 1]; ++k) {
        if (level.conductance[k] <= strongest) continue;
        strongest = level.conductance[k];
        partner = level.column[k];
    }
    const double others = 1 - double(strongest) * level.inverse_diagonal[row];
    return kBoundPair * others < 1 ? partner : -1;
}

/// Merges a row without a partner with the pair of the neighbour of the largest conductance.
void LaplacianSolver::join_neighbour(const Level& level, int row, std::vector<int>& pair,
                                     int& n_pairs) {
    int neighbour = -1;
    float strongest = 0;
    for (int k = level.row_begin[row]; k < level.row_begin[row + 1]; ++k) {
        if (level.conductance[k] <= strongest || pair[level.column[k]] < 0) continue;
        strongest = level.conductance[k];
        neighbour = level.column[k];
    }
    pair[row] = neighbour >= 0 ? pair[neighbour] : n_pairs++;
}

/// Pairs each row with the remaining neighbour of the largest conductance; with kStrong, bound
/// pairs first, and rows without a remaining neighbour join that of the largest conductance.
/// @param single  rows that get no partner; empty: none.
std::vector<int> LaplacianSolver::match_pairs(const Level& level, const std::vector<bool>& single,
                                              int& n_pairs) const {
    std::vector<int> pair(static_cast<std::size_t>(level.n_rows()), -1);
    const auto is_single = [&](int row) { return !single.empty() && single[std::size_t(row)]; };
    n_pairs = 0;
    for (int row = 0; row < level.n_rows() && aggregation_ == Aggregation::kStrong; ++row) {
        const int partner = is_single(row) ? -1 : bound_partner(level, row);
        if (partner < row || is_single(partner) || bound_partner(level, partner) != row) continue;
        pair[row] = pair[partner] = n_pairs++;
    }
    std::vector<int> left;
    for (int row = 0; row < level.n_rows(); ++row) {
        checkpoint_each(row);
        if (pair[row] >= 0) continue;
        int partner = -1;
        float strongest = 0;
        for (int k = level.row_begin[row]; k < level.row_begin[row + 1] && !is_single(row); ++k) {
            if (pair[level.column[k]] >= 0 || level.conductance[k] <= strongest) continue;
            if (is_single(level.column[k])) continue;
            strongest = level.conductance[k];
            partner = level.column[k];
        }
        if (partner < 0 && aggregation_ == Aggregation::kStrong && !is_single(row)) {
            left.push_back(row);
            continue;
        }
        pair[row] = n_pairs;
        if (partner >= 0) pair[partner] = n_pairs;
        ++n_pairs;
    }
    for (const int row : left) join_neighbour(level, row, pair, n_pairs);
    return pair;
}

/// The pairs that kBoundPair keeps single.
/// @param pairs  the level of the pairs of `fine`.
std::vector<bool> LaplacianSolver::bound_pairs(const Level& fine, const Level& pairs) {
    std::vector<double> inner(static_cast<std::size_t>(pairs.n_rows()), 0);
    for (int row = 0; row < fine.n_rows(); ++row) {
        const int pair = fine.aggregate[row];
        for (int k = fine.row_begin[row]; k < fine.row_begin[row + 1]; ++k) {
            if (fine.aggregate[fine.column[k]] == pair) inner[pair] += double(fine.conductance[k]);
        }
    }
    std::vector<bool> bound;
    for (int pair = 0; pair < pairs.n_rows(); ++pair) {
        bound.push_back(inner[pair] * pairs.inverse_diagonal[pair] > 2 * kBoundPair);
    }
    return bound;
}

/// Adds up the rows and columns of each aggregate.
LaplacianSolver::Level LaplacianSolver::merged(const Level& fine, const std::vector<int>& aggregate,
                                               int n_coarse) {
    // Sort the rows by aggregate.
    std::vector<int> begin(static_cast<std::size_t>(n_coarse) + 1, 0);
    for (const int a : aggregate) ++begin[a + 1];
    for (int a = 0; a < n_coarse; ++a) begin[a + 1] += begin[a];
    std::vector<int> members(aggregate.size());
    std::vector<int> next(begin.begin(), begin.end() - 1);
    for (int row = 0; row < fine.n_rows(); ++row) members[next[aggregate[row]]++] = row;
    // Add up the entries; `place` is the entry of a column in the current row.
    Level coarse;
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
        finish_row(coarse);
    }
    invert_diagonal(coarse);
    return coarse;
}

}  // namespace pcvt
