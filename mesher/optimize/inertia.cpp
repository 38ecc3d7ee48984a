#include "mesher/optimize/inertia.hpp"

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>
#include <optional>
#include <random>
#include <span>
#include <utility>
#include <vector>

#include "mesher/base/checkpoint.hpp"

namespace pcvt {
namespace {

/// Steps of the power iteration, which determine the largest eigenvalue to a few percent.
constexpr int kPowerSteps = 60;

using SparseMatrix = Eigen::SparseMatrix<double>;

SparseMatrix lower_triangle(const BlockMatrix& h) {
    std::vector<Eigen::Triplet<double>> entries;
    const auto add = [&entries](int row, int column, const auto& block) {
        for (int k = 0; k < 4; ++k) {
            const int r = 2 * row + k % 2;
            const int c = 2 * column + k / 2;
            if (r >= c) entries.emplace_back(r, c, block[k]);
        }
    };
    for (int i = 0; i < h.n_rows(); ++i) {
        add(i, i, h.diagonal[i]);
        for (int k = h.row_begin[i]; k < h.row_begin[i + 1]; ++k) add(i, h.column[k], h.block[k]);
    }
    SparseMatrix matrix(2 * h.n_rows(), 2 * h.n_rows());
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
}

double largest_eigenvalue(const BlockMatrix& h) {
    Workers workers(1);
    std::mt19937_64 random(0);
    Eigen::VectorXd x(2 * h.n_rows());
    for (double& entry : x) entry = static_cast<double>(random()) * 0x1p-64 - 0.5;
    Eigen::VectorXd y(x.size());
    double eigenvalue = 0;
    for (int step = 0; step < kPowerSteps && x.norm() > 0; ++step) {
        x.normalize();
        eigenvalue = h.multiply(x, y, workers);
        x.swap(y);
    }
    return eigenvalue;
}

/// Counts the eigenvalues of a matrix below a shift, by the pivots of L D L^T. L is computed row by
/// row (T. Davis, ACM Transactions on Mathematical Software 31, 2005), in the order that an
/// approximate minimum degree gives; Eigen's factorisation of this kind cannot be cancelled.
class Inertia {
   public:
    explicit Inertia(const SparseMatrix& lower) : upper_(in_sparse_order(lower)) {
        find_parents();
        find_columns();
    }

    /// Returns nullopt if a pivot is zero.
    std::optional<int> n_below(double shift) {
        std::vector<double> row(static_cast<std::size_t>(n()), 0);
        std::vector<double> pivot(static_cast<std::size_t>(n()), 0);
        std::vector<std::size_t> end(begin_.begin(), begin_.end() - 1);
        std::size_t n_steps = 0;
        int n_negative = 0;
        for (int k = 0; k < n(); ++k) {
            const std::span<const int> pattern = pattern_of_row(k);
            for (SparseMatrix::InnerIterator entry(upper_, k); entry; ++entry) {
                row[std::size_t(entry.index())] += entry.value();
            }
            double diagonal = std::exchange(row[k], 0.0) - shift;
            // Eliminate the entries of the row, the later ones after those on which they depend.
            for (const int i : pattern) {
                const double value = std::exchange(row[i], 0.0);
                for (std::size_t p = begin_[i]; p < end[i]; ++p) {
                    row[rows_[p]] -= values_[p] * value;
                }
                const double entry = value / pivot[i];
                diagonal -= entry * value;
                n_steps += end[i] - begin_[i] + 1;
                rows_[end[i]] = k;
                values_[end[i]++] = entry;
            }
            if (n_steps >= kStepsBetweenCheckpoints) {
                checkpoint();
                n_steps = 0;
            }
            if (diagonal == 0) return std::nullopt;
            pivot[k] = diagonal;
            n_negative += diagonal < 0;
        }
        return n_negative;
    }

   private:
    static constexpr std::size_t kStepsBetweenCheckpoints = 1 << 20;

    int n() const { return static_cast<int>(upper_.cols()); }

    /// The upper triangle, with rows and columns in an order that keeps L sparse.
    static SparseMatrix in_sparse_order(const SparseMatrix& lower) {
        Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> order;
        Eigen::AMDOrdering<int>()(lower.selfadjointView<Eigen::Lower>(), order);
        SparseMatrix upper(lower.rows(), lower.cols());
        upper.selfadjointView<Eigen::Upper>() =
            lower.selfadjointView<Eigen::Lower>().twistedBy(order.inverse());
        return upper;
    }

    /// The elimination tree: the parent of column i is the row of the first entry below the
    /// diagonal of L, or -1.
    void find_parents() {
        parent_.assign(static_cast<std::size_t>(n()), -1);
        std::vector<int> ancestor(static_cast<std::size_t>(n()), -1);
        for (int k = 0; k < n(); ++k) {
            checkpoint_each(k);
            for (SparseMatrix::InnerIterator entry(upper_, k); entry; ++entry) {
                for (auto i = int(entry.index()); i >= 0 && i < k;) {
                    const int next = std::exchange(ancestor[i], k);
                    if (next < 0) parent_[i] = k;
                    i = next;
                }
            }
        }
    }

    /// The columns with entries in row k of L, each after those below it in the tree.
    std::span<const int> pattern_of_row(int k) {
        std::size_t first = pattern_.size();
        mark_[k] = k;
        for (SparseMatrix::InnerIterator entry(upper_, k); entry; ++entry) {
            // The path from this column up to a column that is known.
            path_.clear();
            for (auto i = int(entry.index()); mark_[i] != k; i = parent_[i]) {
                path_.push_back(i);
                mark_[i] = k;
            }
            while (!path_.empty()) {
                pattern_[--first] = path_.back();
                path_.pop_back();
            }
        }
        return std::span(pattern_).subspan(first);
    }

    /// Counts the entries of the columns of L.
    void find_columns() {
        mark_.assign(static_cast<std::size_t>(n()), -1);
        pattern_.resize(static_cast<std::size_t>(n()));
        std::vector<std::size_t> count(static_cast<std::size_t>(n()), 0);
        for (int k = 0; k < n(); ++k) {
            checkpoint_each(k, 64);
            for (const int i : pattern_of_row(k)) ++count[i];
        }
        mark_.assign(static_cast<std::size_t>(n()), -1);
        begin_.assign(1, 0);
        for (const std::size_t entries : count) begin_.push_back(begin_.back() + entries);
        rows_.resize(begin_.back());
        values_.resize(begin_.back());
    }

    SparseMatrix upper_;
    std::vector<int> parent_;
    /// Column i of L has the entries begin_[i] ... begin_[i + 1] - 1 below its diagonal of ones.
    std::vector<std::size_t> begin_;
    std::vector<int> rows_;
    std::vector<double> values_;
    /// The last row in whose pattern a column was found; scratch memory of pattern_of_row().
    std::vector<int> mark_;
    std::vector<int> pattern_;
    std::vector<int> path_;
};

}  // namespace

Minimum minimum_by_inertia(const BlockMatrix& hessian, int n_translations) {
    const double threshold = kCertainEigenvalue * largest_eigenvalue(hessian);
    Inertia inertia(lower_triangle(hessian));
    if (inertia.n_below(threshold) == n_translations) return Minimum::kYes;
    const std::optional<int> n_negative = inertia.n_below(-threshold);
    return n_negative && *n_negative > 0 ? Minimum::kNo : Minimum::kUnknown;
}

}  // namespace pcvt
