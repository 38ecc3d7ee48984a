#include "mesher/plane/energy/hessian.hpp"

#include <gtest/gtest.h>

#include <random>

#include "mesher/plane/energy/energy.hpp"
#include "tests/support/dense.hpp"
#include "tests/support/lattices.hpp"
#include "tests/support/special_sites.hpp"

namespace pcvt::plane {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using testing::dense;

/// An engine whose gradient can be evaluated at slightly displaced sites.
class Engine {
   public:
    explicit Engine(const Sites& sites) : delaunay_(sites), pass_(delaunay_, workers_) {
        pass_.evaluate(energy_);
    }
    BlockMatrix hessian() {
        BlockMatrix h;
        assemble_hessian(delaunay_, workers_, h);
        return h;
    }
    /// The derivative of the gradient along `direction`, by central differences.
    VectorXd derivative(const Eigen::VectorXf& direction) {
        const double t = 1e-6 * delaunay_.spacing();
        return (gradient(direction, t) - gradient(direction, -t)) / (2 * t);
    }
    /// One step of Lloyd's iteration.
    void relax() {
        Eigen::VectorXf step(energy_.gradient.size());
        for (Eigen::Index s = 0; s < energy_.mass.size(); ++s) {
            const Vec2 g = energy_.gradient.segment<2>(2 * s);
            step.segment<2>(2 * s) = (g / (-2 * energy_.mass[s])).cast<float>();
        }
        delaunay_.step(step, 1, workers_);
        pass_.evaluate(energy_);
        delaunay_.settle();
    }

   private:
    VectorXd gradient(const Eigen::VectorXf& direction, double t) {
        Energy there;
        delaunay_.step(direction, t, workers_);
        EXPECT_TRUE(pass_.evaluate(there));
        delaunay_.step_back();
        EXPECT_TRUE(pass_.evaluate(energy_));
        return there.gradient;
    }

    Workers workers_{1};
    MovingDelaunay delaunay_;
    EnergyPass pass_;
    Energy energy_;
};

/// The largest error of H d compared with differences, relative to the largest entry of H and d.
double error_along(Engine& engine, const Eigen::VectorXf& direction) {
    const MatrixXd h = dense(engine.hessian());
    const VectorXd error = h * direction.cast<double>() - engine.derivative(direction);
    return error.cwiseAbs().maxCoeff() / std::max(1.0, h.cwiseAbs().maxCoeff());
}

// Law 1. Random sites make obtuse triangles, relaxed ones acute; few sites are their own
// neighbours.
TEST(Hessian, IsTheDerivativeOfTheGradient) {
    std::mt19937 random(5);
    std::normal_distribution<float> normal;
    for (const auto& [name, lattice] : testing::lattices()) {
        for (const int n : {1, 2, 3, 4, 5, 6, 7, 8, 40}) {
            Engine engine(Sites(lattice, uniform_points(lattice, n, 3)));
            for (int relaxed = 0; relaxed < 12; ++relaxed) {
                Eigen::VectorXf direction(2 * n);
                for (float& x : direction) x = normal(random);
                EXPECT_LT(error_along(engine, direction), 1e-6) << name << n << " " << relaxed;
                engine.relax();
            }
        }
    }
}

TEST(Hessian, EachColumnIsADerivative) {
    const Lattice lattice({1, 0}, {0.37, 0.81});
    Engine engine(Sites(lattice, uniform_points(lattice, 12, 1)));
    for (int k = 0; k < 24; ++k) {
        EXPECT_LT(error_along(engine, Eigen::VectorXf::Unit(24, k)), 1e-7) << k;
    }
}

// Laws 2 and 3.
TEST(Hessian, IsSymmetricAndItsRowsSumToZero) {
    for (const auto& [name, lattice] : testing::lattices()) {
        for (const int n : {1, 2, 3, 5, 8, 100}) {
            const BlockMatrix h = Engine(Sites(lattice, uniform_points(lattice, n, 4))).hessian();
            const MatrixXd matrix = dense(h);
            EXPECT_TRUE(h.annihilates_translations);
            EXPECT_LE((matrix - matrix.transpose()).cwiseAbs().maxCoeff(),
                      n < 10 ? 1e-15 * matrix.cwiseAbs().maxCoeff() : 0)
                << name << n;
            EXPECT_LT((matrix * VectorXd::Unit(2, 0).replicate(n, 1)).norm(),
                      1e-7 * matrix.norm() + 1e-300);
        }
    }
}

// A square with slightly displaced corners has one or the other diagonal as an edge.
TEST(Hessian, IsContinuousWhereAnEdgeFlips) {
    const Lattice lattice = Lattice::rectangle(1, 1);
    for (const int k : {3, 4}) {
        MatrixXd before;
        for (const double move : {1e-9, -1e-9}) {
            Points points(2, k * k);
            for (int s = 0; s < k * k; ++s) {
                points.col(s) = Vec2(s % k + 0.5, s / k + 0.5) / k;
                points.col(s) += move * (s % 3 - 1) * Vec2(1, 0.3);
            }
            const MatrixXd h = dense(Engine(Sites(lattice, points)).hessian());
            if (move < 0) {
                EXPECT_LT((h - before).norm(), 1e-6 * h.norm());
            }
            before = h;
        }
    }
}

// Computed by hand: c = 1 left and right of a side, so H_ij = l (-1/2 along it, 1/6 across); c = 0
// at a diagonal.
TEST(Hessian, OfTheSquareGridEqualsTheHandComputation) {
    const Sites grid = testing::grid_sites(Lattice::rectangle(1, 1), 4, 4, 0.1, 0.1);
    const MatrixXd h = dense(Engine(grid).hessian());
    for (Eigen::Index k = 0; k < h.rows(); ++k) {
        const VectorXd row = h.row(k) / h(0, 0) * (2.0 / 3);
        EXPECT_NEAR(row[k], 1 - 1.0 / 3, 1e-7);
        EXPECT_NEAR(row.minCoeff(), -0.5, 1e-7);
        EXPECT_NEAR(row.cwiseAbs().sum(), 1 - 1.0 / 3 + 1 + 1.0 / 3, 1e-7);
        EXPECT_EQ((row.array().abs() > 1e-7).count(), 5);
    }
}

TEST(Hessian, IsTheSameForAnyNumberOfWorkers) {
    const Lattice lattice({1, 0}, {0.37, 0.81});
    const MovingDelaunay delaunay(Sites(lattice, uniform_points(lattice, 40000, 2)));
    BlockMatrix one;
    VectorXd product_of_one;
    for (const int n_threads : {1, 2, 3}) {
        Workers workers(n_threads);
        BlockMatrix h;
        assemble_hessian(delaunay, workers, h);
        const VectorXd x = VectorXd::LinSpaced(80000, -1, 2);
        VectorXd product(x.size());
        const double dot = h.multiply(x, product, workers);
        EXPECT_NEAR(dot / x.dot(product), 1, 1e-9);
        if (n_threads == 1) one = h;
        if (n_threads == 1) product_of_one = product;
        EXPECT_EQ(h.block, one.block);
        EXPECT_EQ(h.diagonal, one.diagonal);
        EXPECT_EQ(h.column, one.column);
        EXPECT_EQ(product, product_of_one);
    }
}

TEST(BlockMatrix, MultipliesLikeTheDenseMatrix) {
    const Lattice lattice = Lattice::rectangle(20, 1);
    for (const int n : {1, 2, 7, 30}) {
        const BlockMatrix h = Engine(Sites(lattice, uniform_points(lattice, n, 1))).hessian();
        const VectorXd x = VectorXd::LinSpaced(2 * n, -1, 2).cwiseAbs2();
        VectorXd y(2 * n);
        Workers workers(1);
        const double dot = h.multiply(x, y, workers);
        EXPECT_LT((y - dense(h) * x).norm(), 1e-13 * (dense(h).norm() * x.norm() + 1));
        EXPECT_NEAR(dot, x.dot(y), 1e-13 * (x.norm() * y.norm() + 1));
    }
}

}  // namespace
}  // namespace pcvt::plane
