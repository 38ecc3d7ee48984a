#include "mesher/plane/energy/stability.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include "mesher/plane/cvt/cvt.hpp"
#include "mesher/plane/energy/hessian.hpp"
#include "tests/support/lattices.hpp"
#include "tests/support/special_sites.hpp"
#include "tests/support/sublattice.hpp"

namespace pcvt::plane {
namespace {

using testing::sublattice_sites;

// The best lattices of the unit square and their bases.
TEST(Stability, DistinguishesMinimaFromSaddlesAmongTheBestLattices) {
    const Lattice unit = Lattice::rectangle(1, 1);
    EXPECT_EQ(stability(sublattice_sites(unit, {2, 1, 2})), Minimum::kYes);
    EXPECT_EQ(stability(sublattice_sites(unit, {14, 7, 4})), Minimum::kYes);
    EXPECT_EQ(stability(sublattice_sites(unit, {10, 5, 3})), Minimum::kYes);
    EXPECT_EQ(stability(sublattice_sites(unit, {10, 7, 1})), Minimum::kNo);
    EXPECT_EQ(stability(sublattice_sites(unit, {13, 5, 1})), Minimum::kNo);
}

TEST(Stability, OneSiteIsAMinimumAndTheSquareGridIsNot) {
    for (const auto& [name, lattice] : testing::lattices()) {
        EXPECT_EQ(stability(Sites(lattice, uniform_points(lattice, 1, 0))), Minimum::kYes) << name;
    }
    const Lattice unit = Lattice::rectangle(1, 1);
    EXPECT_EQ(stability(testing::grid_sites(unit, 6, 6, 0, 0)), Minimum::kNo);
}

TEST(Stability, HexagonsAreAMinimum) {
    const Lattice hexagonal({1, 0}, {0.5, std::sqrt(0.75)});
    for (const int k : {2, 3, 8, 40}) {
        EXPECT_EQ(stability(testing::grid_sites(hexagonal, k, k, 0.1, 0.2)), Minimum::kYes) << k;
    }
}

/// The answer from all eigenvalues.
Minimum by_eigenvalues(const BlockMatrix& h) {
    Eigen::MatrixXd matrix(2 * h.n_rows(), 2 * h.n_rows());
    Workers workers(1);
    Eigen::VectorXd column(matrix.rows());
    for (Eigen::Index k = 0; k < matrix.cols(); ++k) {
        h.multiply(Eigen::VectorXd::Unit(matrix.rows(), k), column, workers);
        matrix.col(k) = column;
    }
    const Eigen::VectorXd values =
        Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(matrix).eigenvalues();
    const double largest = values[values.size() - 1];
    if (values[0] < -1e-6 * largest) return Minimum::kNo;
    return values[2] > 1e-6 * largest ? Minimum::kYes : Minimum::kUnknown;
}

TEST(Stability, AgreesWithAllEigenvalues) {
    int n_minima = 0;
    int n_states = 0;
    for (const auto& [name, lattice] : testing::lattices()) {
        for (const int n : {2, 3, 8, 40}) {
            for (const int iterations : {0, 5, 20, -1}) {
                CvtOptions options;
                options.run.max_iterations = iterations;
                const CvtResult result =
                    compute_cvt(lattice, uniform_points(lattice, n, 9), options);
                BlockMatrix hessian;
                Workers workers(1);
                assemble_hessian(MovingDelaunay(result.delaunay.sites()), workers, hessian);
                const Minimum answer = stability(hessian);
                EXPECT_EQ(answer, by_eigenvalues(hessian)) << name << n << " " << iterations;
                n_minima += answer == Minimum::kYes;
                ++n_states;
            }
        }
    }
    EXPECT_GT(n_minima, n_states / 4);
    EXPECT_LT(n_minima, n_states);
}

/// A ring of n pairs on springs between neighbours: eigenvalues 2 - 2 cos(2 pi k / n), twice.
BlockMatrix ring_of_springs(int n, float stiffness_of_one) {
    BlockMatrix h;
    h.resize(std::vector<int>(static_cast<std::size_t>(n), 2));
    h.annihilates_translations = true;
    h.diagonal.assign(h.diagonal.size(), {});
    for (int i = 0; i < n; ++i) {
        const int j = (i + 1) % n;
        const float k = i == 0 ? stiffness_of_one : 1;
        h.column[2 * i] = j;
        h.column[2 * j + 1] = i;
        h.block[2 * i] = h.block[2 * j + 1] = {-k, 0, 0, -k};
        for (const int row : {i, j}) h.diagonal[row][0] = h.diagonal[row][3] += k;
    }
    return h;
}

TEST(Stability, IsUnknownForFlatDirections) {
    EXPECT_EQ(stability(ring_of_springs(100, 1)), Minimum::kYes);
    EXPECT_EQ(stability(ring_of_springs(5000, 1)), Minimum::kUnknown);
    EXPECT_EQ(stability(ring_of_springs(100, -1)), Minimum::kNo);
}

}  // namespace
}  // namespace pcvt::plane
