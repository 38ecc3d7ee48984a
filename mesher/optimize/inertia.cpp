#include "mesher/optimize/inertia.hpp"

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <optional>
#include <random>
#include <vector>

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

/// Counts the eigenvalues of a matrix below a shift.
class Inertia {
   public:
    explicit Inertia(const SparseMatrix& lower) : lower_(lower) { ldlt_.analyzePattern(lower_); }

    /// Returns nullopt if a pivot is zero.
    std::optional<Eigen::Index> n_below(double shift) {
        ldlt_.setShift(-shift);
        ldlt_.factorize(lower_);
        if (ldlt_.info() != Eigen::Success) return std::nullopt;
        return (ldlt_.vectorD().array() < 0).count();
    }

   private:
    SparseMatrix lower_;
    Eigen::SimplicialLDLT<SparseMatrix> ldlt_;
};

}  // namespace

Minimum minimum_by_inertia(const BlockMatrix& hessian, int n_translations) {
    const double threshold = kCertainEigenvalue * largest_eigenvalue(hessian);
    Inertia inertia(lower_triangle(hessian));
    if (inertia.n_below(threshold) == n_translations) return Minimum::kYes;
    const auto n_negative = inertia.n_below(-threshold);
    return n_negative && *n_negative > 0 ? Minimum::kNo : Minimum::kUnknown;
}

}  // namespace pcvt
