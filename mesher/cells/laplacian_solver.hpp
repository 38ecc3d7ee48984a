#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <vector>

#include "mesher/cells/cell_graph.hpp"

namespace pcvt {

/// Solves A x = b for the Laplacian of a graph with conductances c_ij,
///
///   (A x)_i  =  sum over j of c_ij (x_i - x_j),
///
/// by conjugate gradients with a multigrid preconditioner: pairs of strongly coupled rows are
/// merged twice per level (double pairwise aggregation), and the coarse problems are solved by two
/// steps of conjugate gradients each (K-cycle; Y. Notay 2010). The number of iterations hardly
/// depends on n, on the sizes of the cells or on the lengths of their edges. Incomplete Cholesky
/// preconditioning needs a number of iterations that grows like sqrt(n).
///
/// Example usage:
///
///     LaplacianSolver solver(graph);
///     Eigen::VectorXd x;
///     solver.solve(b, 1e-8, x);
///
/// Laws, tested by number:
///   (1) |A x - b| <= `accuracy` |b| if b sums to zero; A has conductances in single precision.
///   (2) x sums to zero.
///   (3) At most 40 products give an accuracy of 1e-5, for any n, where conductances differ by a
///       factor of some thousands.
class LaplacianSolver {
   public:
    /// How rows are merged. kPairs: only in pairs, so that rows whose neighbours have partners stay
    /// as they are; where small cells surround large ones, the coarsest problem has some hundred
    /// rows then. kStrong: such rows join their neighbour, and pairs of rows that are much more
    /// strongly coupled to each other than to all others are merged first; a small problem that
    /// needs many products is solved directly in the end.
    enum class Aggregation { kPairs, kStrong };

    /// Builds the hierarchy. O(n).
    explicit LaplacianSolver(const CellGraph& graph, Aggregation aggregation = Aggregation::kPairs);

    /// Takes the conductances of another graph of as many rows, and keeps the hierarchy, which
    /// serves as well if the conductances are nearly equal.
    void replace_finest(const CellGraph& graph);

    /// @param b         its mean is ignored, since A annihilates constants.
    /// @param accuracy  the largest |A x - b| / |b|.
    /// @returns the number of products with A.
    int solve(const Eigen::VectorXd& b, double accuracy, Eigen::VectorXd& x);

   private:
    /// A Laplacian in rows whose entries before `lower_end` have smaller columns.
    struct Level {
        std::vector<int> row_begin{0};
        std::vector<int> lower_end;
        std::vector<int> column;
        /// In single precision: a product with a large matrix is limited by memory bandwidth.
        std::vector<float> conductance;
        Eigen::VectorXd inverse_diagonal;
        /// The row of the next level that each row is merged into.
        std::vector<int> aggregate;
        /// The right-hand side and the solution of the correction; scratch of the K-cycle.
        Eigen::VectorXd b, x, first, product, rest;

        int n_rows() const { return static_cast<int>(lower_end.size()); }
    };

    static Level finest_level(const CellGraph& graph);
    static int bound_partner(const Level& level, int row);
    static void join_neighbour(const Level& level, int row, std::vector<int>& pair, int& n_pairs);
    std::vector<int> match_pairs(const Level& level, const std::vector<bool>& single,
                                 int& n_pairs) const;
    static std::vector<bool> bound_pairs(const Level& fine, const Level& pairs);
    static Level merged(const Level& fine, const std::vector<int>& aggregate, int n_coarse);
    static void finish_row(Level& level);
    static void multiply(const Level& level, const Eigen::VectorXd& x, Eigen::VectorXd& y);
    static void smooth_back(const Level& level, const Eigen::VectorXd& b, Eigen::VectorXd& x);
    void factorize_coarsest();
    static Eigen::LLT<Eigen::MatrixXd> factorized(const Level& level);
    void precondition(std::size_t k, const Eigen::VectorXd& b, Eigen::VectorXd& x);
    void solve_coarse(std::size_t k);

    Aggregation aggregation_;
    std::vector<Level> levels_;
    Eigen::LLT<Eigen::MatrixXd> coarsest_;
};

}  // namespace pcvt
