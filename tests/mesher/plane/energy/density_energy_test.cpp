#include "mesher/plane/energy/density_energy.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "mesher/plane/density/density_survey.hpp"
#include "tests/support/densities.hpp"
#include "tests/support/lattices.hpp"

namespace pcvt::plane {
namespace {

/// Sites after some Lloyd steps, with rules chosen at their positions.
class DensityWalk {
   public:
    DensityWalk(const Lattice& lattice, Density rho, int n, double accuracy, int n_threads = 1)
        : density(std::move(rho)),
          delaunay(Sites(lattice, graded_points(lattice, density, n, 5))),
          workers(n_threads),
          pass(delaunay, workers, lattice, density, 1) {
        EXPECT_TRUE(pass.evaluate(energy));
        for (int k = 0; k < 10; ++k) lloyd_step();
        check = pass.choose_orders(accuracy, true);
        pass.evaluate(energy);
    }

    void lloyd_step() {
        const Eigen::VectorXd masses = energy.mass.replicate(1, 2).transpose().reshaped();
        step((-0.5 * energy.gradient.cwiseQuotient(masses)).cast<float>(), 1);
        delaunay.settle();
    }
    void step(const Eigen::VectorXf& direction, double t) {
        EXPECT_TRUE(delaunay.step(direction, t, workers));
        EXPECT_TRUE(pass.evaluate(energy));
    }
    /// F with one coordinate changed.
    double value_at(int variable, double change) {
        Eigen::VectorXf direction = Eigen::VectorXf::Zero(2 * delaunay.n_sites());
        direction[variable] = 1;
        EXPECT_TRUE(delaunay.step(direction, change, workers));
        Energy there;
        EXPECT_TRUE(pass.evaluate(there));
        delaunay.step_back();
        EXPECT_TRUE(pass.restore());
        return there.value;
    }

    Density density;
    MovingDelaunay delaunay;
    Workers workers;
    DensityPass pass;
    Energy energy;
    RuleCheck check;
};

// Law 1.
TEST(DensityEnergy, OfAConstantEqualsTheUniformEnergy) {
    for (const auto& [name, lattice] : testing::lattices()) {
        SCOPED_TRACE(name);
        DensityWalk walk(lattice, shared_density([](const DensityPoint&) { return 3.0; }), 60,
                         1e-6);
        Energy uniform;
        EnergyPass(walk.delaunay, walk.workers).evaluate(uniform);
        EXPECT_NEAR(walk.energy.value / uniform.value, 3, 1e-12);
        EXPECT_LT((walk.energy.gradient - 3 * uniform.gradient).norm(), 1e-12);
        EXPECT_LT((walk.energy.mass - 3 * uniform.mass).norm(), 1e-12);
        EXPECT_DOUBLE_EQ(walk.pass.range().least, 3);
    }
}

// Law 2.
TEST(DensityEnergy, MassesSumToTheIntegralOfTheDensity) {
    for (const auto& [name, lattice] : testing::lattices()) {
        for (const Density& density : {testing::smooth_density(), testing::ramp_density()}) {
            const DensityWalk walk(lattice, density, 80, 1e-10);
            const double unit = walk.delaunay.unit();
            EXPECT_NEAR(walk.energy.mass.sum() * unit * unit / integral(lattice, density), 1, 1e-9)
                << name;
        }
    }
}

/// The largest difference between the gradient and fourth-order central differences, relative to
/// the cell's mass times its spacing.
double gradient_error(DensityWalk& walk) {
    const double step = 5e-4 * walk.delaunay.spacing();
    double largest = 0;
    for (int k = 0; k < 2 * walk.delaunay.n_sites(); k += 97) {
        const double far = walk.value_at(k, 2 * step) - walk.value_at(k, -2 * step);
        const double near = walk.value_at(k, step) - walk.value_at(k, -step);
        const double slope = (8 * near - far) / (12 * step);
        const double scale = walk.energy.mass[k / 2] * std::sqrt(walk.pass.areas()[k / 2]);
        largest = std::max(largest, std::abs(slope - walk.energy.gradient[k]) / scale);
    }
    return largest;
}

// Law 3.
TEST(DensityEnergy, GradientOfSmoothDensitiesMatchesDifferencesToEightDigits) {
    DensityWalk walk(Lattice::rectangle(1, 1), testing::smooth_density(), 1000, 1e-10);
    EXPECT_LT(gradient_error(walk), 1e-8);
}

TEST(DensityEnergy, GradientOfARidgeMatchesDifferencesToSixDigits) {
    DensityWalk walk(Lattice::rectangle(1, 1), testing::ridge_density(), 1000, 1e-8);
    EXPECT_LT(gradient_error(walk), 1e-6);
}

TEST(DensityEnergy, GradientOfALowOrderDoesNotMatchDifferences) {
    DensityWalk walk(Lattice::rectangle(1, 1), testing::ridge_density(), 1000, 1);
    EXPECT_GT(gradient_error(walk), 1e-5);
}

TEST(DensityEnergy, GradientHoldsAcrossAJumpAtTheSeam) {
    DensityWalk walk(Lattice({1, 0}, {0.37, 0.81}), testing::ramp_density(), 300, 1e-10);
    EXPECT_LT(gradient_error(walk), 1e-8);
}

// Law 4, with repairs in between.
TEST(DensityEnergy, IsTheSameToTheLastBitForAnyNumberOfWorkers) {
    const Lattice lattice({1, 0}, {0.37, 0.81});
    DensityWalk one(lattice, testing::smooth_density(), 3000, 1e-5);
    EXPECT_GT(one.delaunay.counts().n_flips, 0);
    for (const int n_threads : {2, 5}) {
        DensityWalk other(lattice, testing::smooth_density(), 3000, 1e-5, n_threads);
        EXPECT_EQ(other.energy.value, one.energy.value);
        EXPECT_EQ(other.energy.gradient, one.energy.gradient);
        EXPECT_EQ(other.energy.mass, one.energy.mass);
        EXPECT_EQ(other.pass.range().n_evaluations, one.pass.range().n_evaluations);
    }
}

TEST(DensityEnergy, OrdersFollowTheAccuracyAndTheDensity) {
    const Lattice lattice = Lattice::rectangle(1, 1);
    DensityWalk walk(lattice, testing::ridge_density(), 500, 1e-9);
    EXPECT_LE(walk.check.largest_error, 1e-9);
    EXPECT_EQ(walk.check.n_rough, 0);
    const double fine = walk.pass.evaluations_per_site();
    EXPECT_EQ(walk.pass.choose_orders(1e-3, false).n_raised, 0);
    walk.pass.choose_orders(1e-3, true);
    walk.pass.evaluate(walk.energy);
    EXPECT_LT(walk.pass.evaluations_per_site(), 0.7 * fine);
    EXPECT_GT(walk.pass.choose_orders(1e-6, false).n_raised, 50);
}

TEST(DensityEnergy, CellsOnAJumpAreRough) {
    const DensityWalk walk(Lattice::rectangle(1, 1), testing::disc_density(), 500, 1e-6);
    // The number of cells is about the length of the circle in cells of either side.
    EXPECT_GT(walk.check.n_rough, 20);
    EXPECT_LT(walk.check.n_rough, 150);
    EXPECT_GT(walk.check.largest_error, 1e-5);
}

TEST(DensityEnergy, ABadPointIsReportedByTheFirstTaskForAnyNumberOfWorkers) {
    std::string first;
    for (const int n_threads : {1, 4}) {
        const Density hole = shared_density(
            [](const DensityPoint& p) { return p.u > 0.701 && p.u < 0.703 ? 0.0 : 1.0; });
        const Lattice lattice = Lattice::rectangle(1, 1);
        MovingDelaunay delaunay(Sites(lattice, uniform_points(lattice, 5000, 1)));
        Workers workers(n_threads);
        DensityPass pass(delaunay, workers, lattice, hole, 1);
        Energy energy;
        try {
            pass.evaluate(energy);
            FAIL();
        } catch (const BadDensity& error) {
            if (first.empty()) first = error.what();
            EXPECT_EQ(error.what(), first);
        }
    }
}

}  // namespace
}  // namespace pcvt::plane
