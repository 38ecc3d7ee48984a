#include "mesher/cells/laplacian_solver.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace pcvt {
namespace {

/// A periodic grid of rows x columns with conductances exp(`spread` z), z normally distributed.
CellGraph grid_graph(int columns, int rows, double spread, std::mt19937_64& random) {
    std::normal_distribution<double> normal;
    const int n = columns * rows;
    std::vector<double> right(static_cast<std::size_t>(n));
    std::vector<double> up(right.size());
    for (double& c : right) c = std::exp(spread * normal(random));
    for (double& c : up) c = std::exp(spread * normal(random));
    CellGraph graph{.row_begin = {0}, .neighbour = {}, .conductance = {}};
    for (int k = 0; k < n; ++k) {
        const int i = k % columns;
        const int j = k / columns;
        const int left_site = j * columns + (i + columns - 1) % columns;
        const int low_site = (j + rows - 1) % rows * columns + i;
        const auto add = [&](int site, double c) {
            graph.neighbour.push_back(site);
            graph.conductance.push_back(c);
        };
        add(j * columns + (i + 1) % columns, right[k]);
        add(left_site, right[left_site]);
        add((j + 1) % rows * columns + i, up[k]);
        add(low_site, up[low_site]);
        graph.row_begin.push_back(static_cast<int>(graph.neighbour.size()));
    }
    return graph;
}

Eigen::VectorXd product(const CellGraph& graph, const Eigen::VectorXd& x) {
    Eigen::VectorXd y = Eigen::VectorXd::Zero(x.size());
    for (int s = 0; s < graph.n_rows(); ++s) {
        for (int k = graph.row_begin[s]; k < graph.row_begin[s + 1]; ++k) {
            y[s] += graph.conductance[k] * (x[s] - x[graph.neighbour[k]]);
        }
    }
    return y;
}

// Laws 1 to 3.
TEST(LaplacianSolver, NeedsFewProductsForAnySizeAndContrast) {
    std::mt19937_64 random(1);
    std::normal_distribution<double> normal;
    for (const auto& [columns, rows] :
         {std::pair(2, 3), {10, 12}, {40, 40}, {150, 150}, {10'000, 3}, {400, 400}}) {
        for (const double spread : {0.0, 1.0}) {
            const CellGraph graph = grid_graph(columns, rows, spread, random);
            Eigen::VectorXd b(columns * rows);
            for (double& x : b) x = normal(random);
            b.array() -= b.mean();
            Eigen::VectorXd x;
            const int n_products = LaplacianSolver(graph).solve(b, 1e-5, x);
            EXPECT_LT((product(graph, x) - b).norm(), 2e-5 * b.norm());
            EXPECT_NEAR(x.mean(), 0, 1e-12 * x.norm());
            EXPECT_LE(n_products, 40) << columns << " x " << rows << " spread " << spread;
        }
    }
}

TEST(LaplacianSolver, LeavesRowsWithoutNeighboursAlone) {
    const CellGraph one{.row_begin = {0, 0}, .neighbour = {}, .conductance = {}};
    Eigen::VectorXd x;
    LaplacianSolver(one).solve(Eigen::VectorXd::Ones(1), 1e-8, x);
    EXPECT_EQ(x[0], 0);
}

}  // namespace
}  // namespace pcvt
