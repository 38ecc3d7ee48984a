#include "mesher/cells/laplacian_solver.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "mesher/base/checkpoint.hpp"
#include "mesher/base/simd.hpp"
#include "mesher/base/target_clones.hpp"

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

/// The slots of a level, and how many bundles it has.
struct Slots {
    const int* begin;
    const int* middle;
    const int* column;
    const float* conductance;
    int n_bundles;
};

template <class Level>
Slots slots_of(const Level& level) {
    return {level.begin.data(), level.middle.data(), level.column.data(), level.conductance.data(),
            static_cast<int>(level.middle.size())};
}

/// Adds the products of the slots from `slot` to `end` with x to `sum`.
[[gnu::always_inline]] inline void add_products(const Slots& a, int slot, int end, const double* x,
                                                Lanes& sum) {
    for (; slot < end; ++slot) {
        const int* const column = a.column + kLanes * std::ptrdiff_t{slot};
        const float* const conductance = a.conductance + kLanes * std::ptrdiff_t{slot};
        Lanes values;
        Lanes factors;
        for (int lane = 0; lane < kLanes; ++lane) values[lane] = x[column[lane]];
        for (int lane = 0; lane < kLanes; ++lane) factors[lane] = double(conductance[lane]);
        sum += factors * values;
    }
}

/// One sweep of Gauss and Seidel from x = 0, in the order of the places.
PCVT_TARGET_CLONES void sweep_forwards(const Slots& a, const double* inverse_diagonal,
                                       const double* b, double* x) {
    for (int k = 0; k < a.n_bundles; ++k) {
        Lanes sum;
        Lanes inverse;
        std::memcpy(&sum, b + kLanes * k, sizeof sum);
        std::memcpy(&inverse, inverse_diagonal + kLanes * k, sizeof inverse);
        add_products(a, a.begin[k], a.middle[k], x, sum);
        sum *= inverse;
        std::memcpy(x + kLanes * k, &sum, sizeof sum);
    }
}

/// The residual after sweep_forwards(), which has left it only in the columns to come.
PCVT_TARGET_CLONES void residual_after_sweep(const Slots& a, const double* x, double* residual) {
    for (int k = 0; k < a.n_bundles; ++k) {
        Lanes sum{};
        add_products(a, a.middle[k], a.begin[k + 1], x, sum);
        std::memcpy(residual + kLanes * k, &sum, sizeof sum);
    }
}

/// One sweep of Gauss and Seidel against the order of the places.
PCVT_TARGET_CLONES void sweep_back(const Slots& a, const double* inverse_diagonal, const double* b,
                                   double* x) {
    for (int k = a.n_bundles; k-- > 0;) {
        Lanes sum;
        Lanes inverse;
        std::memcpy(&sum, b + kLanes * k, sizeof sum);
        std::memcpy(&inverse, inverse_diagonal + kLanes * k, sizeof inverse);
        add_products(a, a.begin[k], a.begin[k + 1], x, sum);
        sum *= inverse;
        std::memcpy(x + kLanes * k, &sum, sizeof sum);
    }
}

/// y = A x; returns x . y
PCVT_TARGET_CLONES double multiply(const Slots& a, const double* x, double* y) {
    Lanes dot{};
    for (int k = 0; k < a.n_bundles; ++k) {
        Lanes here;
        std::memcpy(&here, x + kLanes * k, sizeof here);
        Lanes sum{};
        for (int slot = a.begin[k]; slot < a.begin[k + 1]; ++slot) {
            const int* const column = a.column + kLanes * std::ptrdiff_t{slot};
            const float* const conductance = a.conductance + kLanes * std::ptrdiff_t{slot};
            Lanes values;
            Lanes factors;
            for (int lane = 0; lane < kLanes; ++lane) values[lane] = x[column[lane]];
            for (int lane = 0; lane < kLanes; ++lane) factors[lane] = double(conductance[lane]);
            sum += factors * (here - values);
        }
        std::memcpy(y + kLanes * k, &sum, sizeof sum);
        dot += here * sum;
    }
    double total = 0;
    for (int lane = 0; lane < kLanes; ++lane) total += dot[lane];
    return total;
}

/// @param n  a multiple of kLanes.
PCVT_TARGET_CLONES double dot_product(const double* a, const double* b, Eigen::Index n) {
    Lanes dot{};
    for (Eigen::Index k = 0; k < n; k += kLanes) {
        Lanes x;
        Lanes y;
        std::memcpy(&x, a + k, sizeof x);
        std::memcpy(&y, b + k, sizeof y);
        dot += x * y;
    }
    double total = 0;
    for (int lane = 0; lane < kLanes; ++lane) total += dot[lane];
    return total;
}

double dot(const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
    return dot_product(a.data(), b.data(), a.size());
}

double norm(const Eigen::VectorXd& a) { return std::sqrt(dot(a, a)); }

}  // namespace

LaplacianSolver::LaplacianSolver(const CellGraph& graph) {
    Matrix fine = matrix_of(graph);
    levels_.push_back(level_of(fine));
    while (fine.n_rows() > kCoarsest) {
        int n_pairs = 0;
        std::vector<int> aggregate = match_pairs(fine, {}, n_pairs);
        const Matrix pairs = merged(fine, aggregate, n_pairs);
        int n_coarse = 0;
        const std::vector<int> second =
            match_pairs(pairs, bound_pairs(fine, aggregate, pairs), n_coarse);
        if (n_coarse > (1 - kLeastReduction) * fine.n_rows()) break;
        for (int& a : aggregate) a = second[a];
        fine = merged(pairs, second, n_coarse);
        levels_.push_back(level_of(fine));
        aggregate_rows(levels_.size() - 2, aggregate);
    }
    factorize_coarsest();
}

void LaplacianSolver::factorize_coarsest() {
    const Level& level = levels_.back();
    if (level.n_places() <= 40 * kCoarsest) coarsest_ = factorized(level);
}

/// Factorizes A + s 1 1^T, which is positive definite and has the same solutions for right-hand
/// sides that sum to zero; places without a row are rows of the identity.
Eigen::LLT<Eigen::MatrixXd> LaplacianSolver::factorized(const Level& level) {
    const int n = level.n_places();
    Eigen::MatrixXd a = Eigen::MatrixXd::Zero(n, n);
    for (int p = 0; p < n; ++p) {
        const int bundle = p / kLanes;
        for (int slot = level.begin[bundle]; slot < level.begin[bundle + 1]; ++slot) {
            const int k = kLanes * slot + p % kLanes;
            a(p, level.column[k]) -= double(level.conductance[k]);
            a(p, p) += double(level.conductance[k]);
        }
    }
    const auto n_rows = static_cast<double>(n - std::count(level.row.begin(), level.row.end(), -1));
    const double mean = a.diagonal().sum() / n_rows;
    const double shift = mean > 0 ? mean / n_rows : 1;
    for (int p = 0; p < n; ++p) {
        for (int q = 0; q < n; ++q) {
            if (level.row[p] >= 0 && level.row[q] >= 0) a(p, q) += shift;
        }
        if (level.row[p] < 0) a(p, p) = 1;
    }
    return Eigen::LLT<Eigen::MatrixXd>(a);
}

/// One cycle on level k, an approximation of x = A^-1 b.
void LaplacianSolver::precondition(std::size_t k, const Eigen::VectorXd& b, Eigen::VectorXd& x) {
    Level& level = levels_[k];
    if (k + 1 == levels_.size() && coarsest_.rows() == level.n_places()) {
        x = coarsest_.solve(b);
        return;
    }
    const Slots slots = slots_of(level);
    const double* const inverse = level.inverse_diagonal.data();
    sweep_forwards(slots, inverse, b.data(), x.data());
    // Solve for the residual.
    if (k + 1 < levels_.size()) {
        Level& coarse = levels_[k + 1];
        residual_after_sweep(slots, x.data(), level.residual.data());
        coarse.b.setZero();
        for (int p = 0; p < level.n_places(); ++p)
            coarse.b[level.aggregate[p]] += level.residual[p];
        solve_coarse(k + 1);
        for (int p = 0; p < level.n_places(); ++p) x[p] += coarse.x[level.aggregate[p]];
    }
    sweep_back(slots, inverse, b.data(), x.data());
}

/// Approximates x = A^-1 b on level k by one or two steps of conjugate gradients.
void LaplacianSolver::solve_coarse(std::size_t k) {
    Level& level = levels_[k];
    if (k + 1 == levels_.size()) return precondition(k, level.b, level.x);
    const Slots slots = slots_of(level);
    // The calls below overwrite level k + 1 and the residual only.
    Eigen::VectorXd& first = level.first;
    Eigen::VectorXd& product = level.product;
    precondition(k, level.b, first);
    const double rho = multiply(slots, first.data(), product.data());
    if (!(rho > 0)) {
        level.x.setZero();
        return;
    }
    const double alpha = dot(first, level.b) / rho;
    level.rest = level.b - alpha * product;
    if (norm(level.rest) <= kSecondStep * norm(level.b)) {
        level.x = alpha * first;
        return;
    }
    Eigen::VectorXd& second = level.x;
    precondition(k, level.rest, second);
    const double gamma = dot(second, product);
    const double alpha_second = dot(second, level.rest);
    const double rho_second = multiply(slots, second.data(), product.data()) - gamma * gamma / rho;
    if (!(rho_second > 0)) {
        level.x = alpha * first;
        return;
    }
    level.x = (alpha - gamma * alpha_second / (rho * rho_second)) * first +
              Eigen::VectorXd(alpha_second / rho_second * second);
}

int LaplacianSolver::solve(const Eigen::VectorXd& b, double accuracy, Eigen::VectorXd& x) {
    const Level& level = levels_.front();
    const Slots slots = slots_of(level);
    const Eigen::Index n = level.n_places();
    const double mean = b.mean();
    Eigen::VectorXd residual = Eigen::VectorXd::Zero(n);
    for (Eigen::Index p = 0; p < n; ++p) {
        if (level.row[p] >= 0) residual[p] = b[level.row[p]] - mean;
    }
    const double enough = accuracy * norm(residual);
    Eigen::VectorXd solution = Eigen::VectorXd::Zero(n);
    Eigen::VectorXd z = Eigen::VectorXd::Zero(n);
    Eigen::VectorXd direction = Eigen::VectorXd::Zero(n);
    Eigen::VectorXd product(n);
    double last = 0;
    int n_products = 0;
    const bool may_be_direct = b.size() <= kDirect;
    const int most = may_be_direct ? kMostProductsBeforeDirect : kMostProducts;
    // Conjugate gradients for a preconditioner that changes from step to step.
    for (; norm(residual) > enough && n_products < most; ++n_products) {
        checkpoint();
        precondition(0, residual, z);
        const double beta = last > 0 ? -dot(z, product) / last : 0;
        direction = z + beta * direction;
        last = multiply(slots, direction.data(), product.data());
        if (!(last > 0)) break;
        const double alpha = dot(direction, residual) / last;
        solution += alpha * direction;
        residual -= alpha * product;
    }
    if (may_be_direct && norm(residual) > enough) solution += factorized(level).solve(residual);
    x.resize(b.size());
    for (Eigen::Index p = 0; p < n; ++p) {
        if (level.row[p] >= 0) x[level.row[p]] = solution[p];
    }
    remove_mean(x);
    return n_products;
}

}  // namespace pcvt
