#include "mesher/cells/laplacian_solver.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <tuple>
#include <vector>

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

CellGraph graph_of(int n, const std::vector<std::tuple<int, int, double>>& edges) {
    CellGraph graph{.row_begin = {0}, .neighbour = {}, .conductance = {}};
    for (int row = 0; row < n; ++row) {
        for (const auto& [s, t, c] : edges) {
            if (s != row && t != row) continue;
            graph.neighbour.push_back(s == row ? t : s);
            graph.conductance.push_back(c);
        }
        graph.row_begin.push_back(static_cast<int>(graph.neighbour.size()));
    }
    return graph;
}

int products_to_solve(const CellGraph& graph) {
    std::mt19937_64 random(2);
    std::normal_distribution<double> normal;
    Eigen::VectorXd b(graph.n_rows());
    for (double& x : b) x = normal(random);
    b.array() -= b.mean();
    Eigen::VectorXd x;
    const int n_products = LaplacianSolver(graph).solve(b, 1e-5, x);
    const bool solved = (product(graph, x) - b).norm() < 2e-5 * b.norm();
    return solved ? n_products : -1;
}

// Two sites at a tiny distance, many times, in another order than their neighbours.
TEST(LaplacianSolver, MergesBoundPairsFirst) {
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> uniform(0.5, 2);
    const int n = 400;
    std::vector<std::tuple<int, int, double>> edges;
    for (int s = 0; s < n; ++s) {
        for (const int step : {1, 20}) edges.emplace_back(s, (s + step) % n, uniform(random));
    }
    for (int s = 0; s < n / 2; s += 2) edges.emplace_back(s, n - 1 - s, 1e6 * uniform(random));
    const CellGraph graph = graph_of(n, edges);
    const int n_products = products_to_solve(graph);
    EXPECT_GT(n_products, 0);
    EXPECT_LE(n_products, 60);
}

// Large cells with thousands of small ones round them leave most rows without a partner.
TEST(LaplacianSolver, LetsRowsWithoutPartnersJoinTheirNeighbour) {
    std::mt19937_64 random(4);
    std::uniform_real_distribution<double> uniform(0.5, 2);
    std::vector<std::tuple<int, int, double>> edges;
    const int n_large = 4;
    const int n = 3000;
    for (int s = 0; s < n_large; ++s) edges.emplace_back(s, (s + 1) % n_large, uniform(random));
    for (int s = n_large; s < n; ++s) edges.emplace_back(s % n_large, s, uniform(random));
    const CellGraph graph = graph_of(n, edges);
    const int n_products = products_to_solve(graph);
    EXPECT_GT(n_products, 0);
    EXPECT_LE(n_products, 10);
}

// Law 4: conductances that change by a tenth, and a few edges that turn.
TEST(LaplacianSolver, KeepsItsHierarchyForNearlyEqualConductances) {
    std::mt19937_64 random(5);
    std::normal_distribution<double> normal;
    for (const auto& [columns, rows] : {std::pair(5, 4), {60, 50}, {150, 150}}) {
        CellGraph graph = grid_graph(columns, rows, 1, random);
        LaplacianSolver solver(graph);
        const int before = graph.n_rows() / 2;
        CellGraph other{.row_begin = {0}, .neighbour = {}, .conductance = {}};
        for (int row = 0; row < graph.n_rows(); ++row) {
            for (int k = graph.row_begin[row]; k < graph.row_begin[row + 1]; ++k) {
                const int column = graph.neighbour[k];
                other.neighbour.push_back(column);
                other.conductance.push_back(graph.conductance[k] *
                                            (1 + 0.1 * std::sin(double(row + column))));
            }
            for (const int column : {row == 0 ? before : -1, row == before ? 0 : -1}) {
                if (column < 0) continue;
                other.neighbour.push_back(column);
                other.conductance.push_back(0.5);
            }
            other.row_begin.push_back(static_cast<int>(other.neighbour.size()));
        }
        solver.replace_finest(other);
        Eigen::VectorXd b(graph.n_rows());
        for (double& x : b) x = normal(random);
        b.array() -= b.mean();
        Eigen::VectorXd x;
        EXPECT_LE(solver.solve(b, 1e-5, x), 40);
        EXPECT_LT((product(other, x) - b).norm(), 2e-5 * b.norm());
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
