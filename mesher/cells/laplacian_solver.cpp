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
/// A problem with at most kDirect rows is solved directly once it has taken
/// kMostProductsBeforeDirect products.
constexpr int kDirect = 1000;
constexpr int kMostProductsBeforeDirect = 100;

void remove_mean(Eigen::VectorXd& x) { x.array() -= x.mean(); }

}  // namespace

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

void LaplacianSolver::factorize_coarsest() {
    const Level& level = levels_.back();
    if (level.n_rows() <= 40 * kCoarsest) coarsest_ = factorized(level);
}

/// Factorizes A + s 1 1^T, which is positive definite and has the same solutions for right-hand
/// sides that sum to zero.
Eigen::LLT<Eigen::MatrixXd> LaplacianSolver::factorized(const Level& level) {
    const int n = level.n_rows();
    Eigen::MatrixXd a = Eigen::MatrixXd::Zero(n, n);
    for (int row = 0; row < n; ++row) {
        for (int k = level.row_begin[row]; k < level.row_begin[row + 1]; ++k) {
            a(row, level.column[k]) -= double(level.conductance[k]);
            a(row, row) += double(level.conductance[k]);
        }
    }
    const double mean = a.diagonal().mean();
    a.array() += mean > 0 ? mean / n : 1;
    return Eigen::LLT<Eigen::MatrixXd>(a);
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
    const bool may_be_direct = aggregation_ == Aggregation::kStrong && level.n_rows() <= kDirect;
    const int most = may_be_direct ? kMostProductsBeforeDirect : kMostProducts;
    // Conjugate gradients for a preconditioner that changes from step to step.
    for (; residual.norm() > enough && n_products < most; ++n_products) {
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
    if (may_be_direct && residual.norm() > enough) x += factorized(level).solve(residual);
    remove_mean(x);
    return n_products;
}

}  // namespace pcvt
