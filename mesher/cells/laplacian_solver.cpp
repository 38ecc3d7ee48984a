#include "mesher/cells/laplacian_solver.hpp"

#include <algorithm>
#include <cmath>

#include "mesher/base/checkpoint.hpp"

namespace pcvt {
namespace {

/// A problem with at most this many rows is solved directly.
constexpr int kCoarsest = 60;
/// Merging ends where it removes less than this share of the rows.
constexpr double kLeastReduction = 0.1;
/// A coarse problem is solved by a second step if the first one leaves more than this of the
/// residual (Y. Notay 2010).
constexpr double kSecondStep = 0.25;
constexpr int kMostProducts = 400;
/// A pair of rows so much more strongly coupled to each other than to all others is merged first,
/// and with no second pair at once: sweeps hardly change its mean, which needs a coarse row.
constexpr double kBoundPair = 256;

void remove_mean(Eigen::VectorXd& x) { x.array() -= x.mean(); }

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

LaplacianSolver::LaplacianSolver(const CellGraph& graph, Aggregation aggregation)
    : aggregation_(aggregation) {
    levels_.push_back(finest_level(graph));
    while (levels_.back().n_rows() > kCoarsest) {
        Level& fine = levels_.back();
        int n_pairs = 0;
        fine.aggregate = match_pairs(fine, {}, n_pairs);
        const Level pairs = merged(fine, fine.aggregate, n_pairs);
        int n_coarse = 0;
        std::vector<bool> bound;
        if (aggregation_ == Aggregation::kStrong) bound = bound_pairs(fine, pairs);
        const std::vector<int> second = match_pairs(pairs, bound, n_coarse);
        if (n_coarse > (1 - kLeastReduction) * fine.n_rows()) break;
        for (int& a : fine.aggregate) a = second[a];
        levels_.push_back(merged(pairs, second, n_coarse));
    }
    for (Level& level : levels_) {
        for (Eigen::VectorXd* v : {&level.b, &level.x, &level.first, &level.product, &level.rest}) {
            v->setZero(level.n_rows());
        }
    }
    factorize_coarsest();
}

/// Factorizes A + s 1 1^T, which is positive definite and has the same solutions for right-hand
/// sides that sum to zero.
void LaplacianSolver::factorize_coarsest() {
    const Level& level = levels_.back();
    const int n = level.n_rows();
    if (n > 40 * kCoarsest) return;
    Eigen::MatrixXd a = Eigen::MatrixXd::Zero(n, n);
    for (int row = 0; row < n; ++row) {
        for (int k = level.row_begin[row]; k < level.row_begin[row + 1]; ++k) {
            a(row, level.column[k]) -= double(level.conductance[k]);
            a(row, row) += double(level.conductance[k]);
        }
    }
    const double mean = a.diagonal().mean();
    a.array() += mean > 0 ? mean / n : 1;
    coarsest_.compute(a);
}

/// y = A x
void LaplacianSolver::multiply(const Level& level, const Eigen::VectorXd& x, Eigen::VectorXd& y) {
    for (int row = 0; row < level.n_rows(); ++row) {
        double sum = 0;
        for (int k = level.row_begin[row]; k < level.row_begin[row + 1]; ++k) {
            sum += double(level.conductance[k]) * (x[row] - x[level.column[k]]);
        }
        y[row] = sum;
    }
}

/// One sweep of Gauss and Seidel from the last row to the first.
void LaplacianSolver::smooth_back(const Level& level, const Eigen::VectorXd& b,
                                  Eigen::VectorXd& x) {
    for (int row = level.n_rows(); row-- > 0;) {
        double sum = b[row];
        for (int k = level.row_begin[row]; k < level.row_begin[row + 1]; ++k) {
            sum += double(level.conductance[k]) * x[level.column[k]];
        }
        x[row] = sum * level.inverse_diagonal[row];
    }
}

/// One cycle on level k, an approximation of x = A^-1 b.
void LaplacianSolver::precondition(std::size_t k, const Eigen::VectorXd& b, Eigen::VectorXd& x) {
    Level& level = levels_[k];
    if (k + 1 == levels_.size() && coarsest_.rows() == level.n_rows()) {
        x = coarsest_.solve(b);
        remove_mean(x);
        return;
    }
    // Sweep forwards from x = 0.
    for (int row = 0; row < level.n_rows(); ++row) {
        double sum = b[row];
        for (int e = level.row_begin[row]; e < level.lower_end[row]; ++e) {
            sum += double(level.conductance[e]) * x[level.column[e]];
        }
        x[row] = sum * level.inverse_diagonal[row];
    }
    // Solve for the residual, which the sweep has left only in the larger columns.
    if (k + 1 < levels_.size()) {
        Level& coarse = levels_[k + 1];
        coarse.b.setZero();
        for (int row = 0; row < level.n_rows(); ++row) {
            double residual = 0;
            for (int e = level.lower_end[row]; e < level.row_begin[row + 1]; ++e) {
                residual += double(level.conductance[e]) * x[level.column[e]];
            }
            coarse.b[level.aggregate[row]] += residual;
        }
        solve_coarse(k + 1);
        for (int row = 0; row < level.n_rows(); ++row) x[row] += coarse.x[level.aggregate[row]];
    }
    smooth_back(level, b, x);
}

/// Approximates x = A^-1 b on level k by one or two steps of conjugate gradients.
void LaplacianSolver::solve_coarse(std::size_t k) {
    Level& level = levels_[k];
    if (k + 1 == levels_.size()) return precondition(k, Eigen::VectorXd(level.b), level.x);
    // The calls below overwrite level k + 1 only; this one needs its own copies.
    Eigen::VectorXd& first = level.first;
    Eigen::VectorXd& product = level.product;
    precondition(k, level.b, first);
    multiply(level, first, product);
    const double rho = first.dot(product);
    if (!(rho > 0)) {
        level.x.setZero();
        return;
    }
    const double alpha = first.dot(level.b) / rho;
    level.rest = level.b - alpha * product;
    if (level.rest.norm() <= kSecondStep * level.b.norm()) {
        level.x = alpha * first;
        return;
    }
    Eigen::VectorXd& second = level.x;
    precondition(k, level.rest, second);
    const double gamma = second.dot(product);
    const double alpha_second = second.dot(level.rest);
    multiply(level, second, product);
    const double rho_second = second.dot(product) - gamma * gamma / rho;
    if (!(rho_second > 0)) {
        level.x = alpha * first;
        return;
    }
    level.x = (alpha - gamma * alpha_second / (rho * rho_second)) * first +
              Eigen::VectorXd(alpha_second / rho_second * second);
}

int LaplacianSolver::solve(const Eigen::VectorXd& b, double accuracy, Eigen::VectorXd& x) {
    const Level& level = levels_.front();
    Eigen::VectorXd residual = b;
    remove_mean(residual);
    const double enough = accuracy * residual.norm();
    x.setZero(b.size());
    Eigen::VectorXd z(b.size());
    Eigen::VectorXd direction = Eigen::VectorXd::Zero(b.size());
    Eigen::VectorXd product(b.size());
    double last = 0;
    int n_products = 0;
    // Conjugate gradients for a preconditioner that changes from step to step.
    for (; residual.norm() > enough && n_products < kMostProducts; ++n_products) {
        checkpoint();
        precondition(0, residual, z);
        const double beta = last > 0 ? -z.dot(product) / last : 0;
        direction = z + beta * direction;
        multiply(level, direction, product);
        last = direction.dot(product);
        if (!(last > 0)) break;
        const double alpha = direction.dot(residual) / last;
        x += alpha * direction;
        residual -= alpha * product;
    }
    remove_mean(x);
    return n_products;
}

}  // namespace pcvt
