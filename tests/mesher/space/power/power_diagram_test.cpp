#include "mesher/space/power/power_diagram.hpp"

#include <gtest/gtest.h>

#include <random>

#include "mesher/space/cvt/volume_newton.hpp"
#include "mesher/space/power/power_flips.hpp"
#include "tests/support/space_lattices.hpp"
#include "tests/support/space_laws.hpp"
#include "tests/support/space_weights.hpp"

namespace pcvt::space {
namespace {

// A jump from Delaunay tetrahedra to the final weights gets stuck; halves of the way end, and at
// the same tetrahedra.
TEST(SpacePowerDiagram, SlowHalvesTheWayWhereFlipsAreStuck) {
    const int n = 10'000;
    Workers workers(2);
    int n_halvings = 0;
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        std::mt19937_64 random(seed);
        const MovingTetrahedra moving(
            Sites(testing::kCube, uniform_points(testing::kCube, n, seed)));
        VolumeNewton newton(moving, workers);
        const double spread = seed == 3 ? 0.6 : 0.35;
        const SizeFigures figures = newton.solve(
            testing::lognormal_volumes(n, spread, moving.frame().volume(), random), 1e-10);
        ASSERT_TRUE(figures.converged);
        PowerDiagram jump(moving, workers);
        jump.start();
        ASSERT_TRUE(jump.set_weights(newton.weights()));
        n_halvings += jump.counts().n_halvings;
        EXPECT_EQ(testing::canonical_tetrahedra(jump.tetrahedra()),
                  testing::canonical_tetrahedra(newton.diagram().tetrahedra()));
        EXPECT_LT((jump.sizes() - newton.sizes()).cwiseAbs().maxCoeff(),
                  1e-12 * moving.frame().volume() / n);
    }
    EXPECT_GT(n_halvings, 0);
}

TEST(SpacePowerDiagram, NamesAHiddenSiteAndRefusesNumbersThatAreNotFinite) {
    const int n = 50;
    Workers workers(1);
    const MovingTetrahedra moving(Sites(testing::kCube, uniform_points(testing::kCube, n, 1)));
    PowerDiagram diagram(moving, workers);
    Eigen::VectorXd weights = Eigen::VectorXd::Zero(n);
    for (const double w : {-5.0, -100.0, -1e300}) {
        weights[7] = w * std::pow(moving.spacing(), 2);
        diagram.start();
        EXPECT_FALSE(diagram.set_weights(weights));
        EXPECT_EQ(diagram.hidden_site(), 7);
    }
    weights[7] = std::numeric_limits<double>::quiet_NaN();
    diagram.start();
    EXPECT_FALSE(diagram.set_weights(weights));
    EXPECT_EQ(diagram.hidden_site(), std::nullopt);
    diagram.start();
    EXPECT_TRUE(diagram.set_weights(Eigen::VectorXd::Zero(n)));
}

// A diagram that begins at another one does not change it, and goes on without a start.
TEST(SpacePowerDiagram, LeavesTheDiagramWhereItBegan) {
    const int n = 200;
    std::mt19937_64 random(3);
    Workers workers(1);
    const Sites sites(testing::kCube, uniform_points(testing::kCube, n, 2));
    const MovingTetrahedra moving(sites);
    const double h2 = std::pow(moving.spacing(), 2);
    const auto weights = [&] {
        Eigen::VectorXd w(n);
        for (double& x : w) x = 0.02 * h2 * testing::random_number(random);
        return w;
    };
    PowerDiagram here(moving, workers);
    here.start();
    ASSERT_TRUE(here.set_weights(weights()));
    const auto before = testing::canonical_tetrahedra(here.tetrahedra());
    const Eigen::VectorXd sizes = here.sizes();
    PowerDiagram trial(moving, workers);
    trial.start(here);
    ASSERT_TRUE(trial.set_weights(weights()));
    EXPECT_EQ(testing::canonical_tetrahedra(here.tetrahedra()), before);
    EXPECT_NE(testing::canonical_tetrahedra(trial.tetrahedra()), before);
    ASSERT_TRUE(trial.set_weights(here.weights()));
    EXPECT_EQ(testing::canonical_tetrahedra(trial.tetrahedra()), before);
    EXPECT_LT((trial.sizes() - sizes).cwiseAbs().maxCoeff(), 1e-13 * moving.frame().volume());
}

}  // namespace
}  // namespace pcvt::space
