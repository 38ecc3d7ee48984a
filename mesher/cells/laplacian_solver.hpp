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
/// steps of conjugate gradients each (K-cycle; Y. Notay 2010). Rows whose neighbours have partners
/// join one of them, and pairs of rows that are much more strongly coupled to each other than to
/// all others are merged first. The number of iterations hardly depends on n, on the sizes of the
/// cells or on the lengths of their edges. Incomplete Cholesky preconditioning needs a number of
/// iterations that grows like sqrt(n).
///
/// Sweeps of Gauss and Seidel go by blocks of rows, and in each block by colours: rows of a colour
/// are not neighbours, so that kLanes of them are processed side by side.
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
///   (4) The same products suffice after replace_finest() with conductances that differ by a tenth.
class LaplacianSolver {
   public:
    /// Builds the hierarchy. O(n).
    explicit LaplacianSolver(const CellGraph& graph);

    /// Takes the conductances of another graph of as many rows, and keeps the hierarchy, which
    /// serves as well if the conductances are nearly equal.
    void replace_finest(const CellGraph& graph);

    /// A small problem that needs many products is solved directly in the end.
    /// @param b         its mean is ignored, since A annihilates constants.
    /// @param accuracy  the largest |A x - b| / |b|.
    /// @returns the number of products with A.
    int solve(const Eigen::VectorXd& b, double accuracy, Eigen::VectorXd& x);

   private:
    /// A Laplacian whose rows are being merged.
    struct Matrix {
        std::vector<int> row_begin{0};
        std::vector<int> column;
        std::vector<float> conductance;
        /// 0 for rows without a neighbour, which keeps them out of the solution.
        std::vector<double> inverse_diagonal;

        int n_rows() const { return static_cast<int>(row_begin.size()) - 1; }
    };

    /// A Laplacian in the order of sweeps. Rows of one colour of a block fill bundles of kLanes
    /// places; places that are left over have no row. Lane l of slot k is the entry kLanes k + l.
    struct Level {
        /// The row at each place, or -1.
        std::vector<int> row;
        /// Slots begin[k] to begin[k + 1] belong to bundle k; those before middle[k] have columns
        /// that a sweep has passed.
        std::vector<int> begin{0};
        std::vector<int> middle;
        std::vector<int> column;
        /// In single precision: a product with a large matrix is limited by memory bandwidth.
        std::vector<float> conductance;
        Eigen::VectorXd inverse_diagonal;
        /// The place in the next level of the row that each row is merged into.
        std::vector<int> aggregate;
        /// The right-hand side and the solution of the correction; scratch of the K-cycle.
        Eigen::VectorXd b, x, first, product, rest, residual;

        int n_places() const { return static_cast<int>(row.size()); }
    };

    static Matrix matrix_of(const CellGraph& graph);
    static int bound_partner(const Matrix& matrix, int row);
    static void join_neighbour(const Matrix& matrix, int row, std::vector<int>& pair, int& n_pairs);
    static std::vector<int> match_pairs(const Matrix& matrix, const std::vector<bool>& single,
                                        int& n_pairs);
    static std::vector<bool> bound_pairs(const Matrix& fine, const std::vector<int>& pair_of,
                                         const Matrix& pairs);
    static Matrix merged(const Matrix& fine, const std::vector<int>& aggregate, int n_coarse);

    static std::vector<int> colours_of(const Matrix& matrix);
    static Level level_of(const Matrix& matrix);
    static void fill_lane(const Matrix& matrix, const std::vector<int>& stage,
                          const std::vector<int>& place, int first, int lane, Level& level);
    void aggregate_rows(std::size_t k, const std::vector<int>& aggregate);
    void factorize_coarsest();
    static Eigen::LLT<Eigen::MatrixXd> factorized(const Level& level);
    void precondition(std::size_t k, const Eigen::VectorXd& b, Eigen::VectorXd& x);
    void solve_coarse(std::size_t k);

    std::vector<Level> levels_;
    Eigen::LLT<Eigen::MatrixXd> coarsest_;
};

}  // namespace pcvt
