#include "mesher/space/delaunay/moving_tetrahedra.hpp"

#include <gtest/gtest.h>

#include "mesher/space/energy/energy_pass.hpp"
#include "tests/support/space_families.hpp"
#include "tests/support/space_laws.hpp"

namespace pcvt::space {
namespace {

Eigen::VectorXf random_direction(int n, double size, std::mt19937_64& random) {
    std::uniform_real_distribution<float> uniform(-float(size), float(size));
    Eigen::VectorXf direction(MovingTetrahedra::kNumbersPerSite * n);
    for (float& x : direction) x = uniform(random);
    return direction;
}

/// The triangulation is that of a torus; energy, gradient and volumes are those of a new build.
void expect_new_build(const MovingTetrahedra& moving, const Lattice& lattice,
                      const Energy& energy) {
    testing::expect_torus(moving.tetrahedra(), moving.coordinates());
    const Sites sites(lattice, reduce(lattice), moving.coordinates());
    const PeriodicDelaunay fresh = periodic_delaunay(sites);
    Workers workers(1);
    Energy expected;
    EnergySums().run(fresh.tetrahedra, sites.coordinates(), moving.frame(), workers, expected);
    EXPECT_NEAR(energy.value, expected.value, 1e-12 * expected.value);
    EXPECT_LT((energy.gradient - expected.gradient).norm(), 1e-12 * expected.gradient.norm());
    EXPECT_LT((energy.mass - expected.mass).norm(), 1e-12 * expected.mass.norm());
}

/// Laws 1 and 2 after jumps of all sizes, some of which are taken back.
TEST(MovingTetrahedra, EqualsANewBuildAfterJumps) {
    std::mt19937_64 random(1);
    Workers workers(1);
    for (int job = 0; job < 12; ++job) {
        SCOPED_TRACE(job);
        const Lattice lattice = testing::random_space_lattice(random);
        const int n = 1 + int(random() % 40);
        MovingTetrahedra moving(Sites(lattice, uniform_points(lattice, n, random())));
        EnergyPass pass(moving, workers);
        Energy energy;
        for (int jump = 0; jump < 6; ++jump) {
            const double size = moving.frame().ax * std::pow(10.0, -double(random() % 5));
            const Eigen::VectorXf direction = random_direction(n, size, random);
            ASSERT_TRUE(moving.step(direction, 0.5, workers));
            if (jump % 3 == 2) moving.step_back();
            ASSERT_TRUE(pass.evaluate(energy));
            moving.settle();
            expect_new_build(moving, lattice, energy);
        }
    }
}

/// Flips append tetrahedra wherever there is room; sorted again, neighbours stay close in memory.
TEST(MovingTetrahedra, KeepNeighboursCloseInMemory) {
    Workers workers(1);
    const int n = 3000;
    const Lattice cube = Lattice::box(1, 1, 1);
    MovingTetrahedra moving(Sites(cube, uniform_points(cube, n, 1)));
    EnergyPass pass(moving, workers);
    Energy energy;
    ASSERT_TRUE(pass.evaluate(energy));
    const auto share_of_far_neighbours = [&] {
        const TorusTetrahedra& tetrahedra = moving.tetrahedra();
        int n_far = 0;
        for (int f = 0; f < tetrahedra.n_facets(); ++f) {
            if (std::abs(tetrahedra.opposite(f) - f) > tetrahedra.n_facets() / 10) ++n_far;
        }
        return double(n_far) / tetrahedra.n_facets();
    };
    const double at_first = share_of_far_neighbours();
    std::mt19937_64 random(3);
    const double size = 0.03 * moving.spacing();
    for (int k = 0; k < 60; ++k) {
        ASSERT_TRUE(moving.step(random_direction(n, size, random), 1, workers));
        ASSERT_TRUE(pass.evaluate(energy));
        moving.settle();
    }
    EXPECT_GT(moving.n_flips(), moving.tetrahedra().n_tetrahedra());
    EXPECT_LT(share_of_far_neighbours(), 1.5 * at_first);
}

/// Lloyd's method from random sites inverts tetrahedra in its first steps. The first two steps may
/// break so many facets that a new build is faster; after each later step, a local repair suffices.
TEST(MovingTetrahedra, NeedsANewBuildOnlyAfterTheFirstSteps) {
    Workers workers(1);
    const Lattice cube = Lattice::box(1, 1, 1);
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        int first_rebuilds = 0;
        MovingTetrahedra moving(Sites(cube, uniform_points(cube, 500, seed)));
        EnergyPass pass(moving, workers);
        Energy energy;
        ASSERT_TRUE(pass.evaluate(energy));
        for (int k = 0; k < 10; ++k) {
            Eigen::VectorXf direction = Eigen::VectorXf::Zero(4 * moving.n_sites());
            for (SiteId s = 0; s < moving.n_sites(); ++s) {
                direction.segment<3>(4 * s) =
                    (energy.gradient.segment<3>(MovingTetrahedra::kNumbersPerSite * s) /
                     (-2 * energy.mass[s]))
                        .cast<float>();
            }
            ASSERT_TRUE(moving.step(direction, 1.5, workers));
            ASSERT_TRUE(pass.evaluate(energy));
            moving.settle();
            expect_new_build(moving, cube, energy);
            if (k == 1) first_rebuilds = moving.n_rebuilds();
        }
        EXPECT_GT(moving.n_flips(), 500);
        EXPECT_EQ(moving.n_rebuilds(), first_rebuilds) << "seed " << seed;
    }
}

TEST(MovingTetrahedra, StepBackRestoresEveryCoordinate) {
    std::mt19937_64 random(2);
    Workers workers(1);
    const Lattice cube = Lattice::box(1, 1, 1);
    MovingTetrahedra moving(Sites(cube, uniform_points(cube, 20, 1)));
    EnergyPass pass(moving, workers);
    Energy energy;
    ASSERT_TRUE(pass.evaluate(energy));
    const double before = energy.value;
    for (const double size : {1e-6, 0.1, 1.0}) {
        const Eigen::VectorXf direction = random_direction(20, size, random);
        ASSERT_TRUE(moving.step(direction, 1, workers));
        ASSERT_TRUE(pass.evaluate(energy));
        moving.step_back();
        ASSERT_TRUE(pass.evaluate(energy));
        EXPECT_NEAR(energy.value, before, 1e-14 * before);
    }
}

TEST(MovingTetrahedra, RefusesMovesThatAreNotFinite) {
    Workers workers(2);
    const Lattice cube = Lattice::box(1, 1, 1);
    MovingTetrahedra moving(Sites(cube, uniform_points(cube, 5, 1)));
    Eigen::VectorXf direction = Eigen::VectorXf::Zero(20);
    direction[9] = std::numeric_limits<float>::quiet_NaN();
    EXPECT_FALSE(moving.step(direction, 1, workers));
    direction[9] = std::numeric_limits<float>::infinity();
    EXPECT_FALSE(moving.step(direction, 1, workers));
    EXPECT_TRUE(moving.settled());
}

TEST(MovingTetrahedra, ReportsSitesThatCoincide) {
    const Lattice cube = Lattice::box(1, 1, 1);
    Points points(3, 2);
    points << 0.25, 0.5, 0.25, 0.5, 0.25, 0.5;
    MovingTetrahedra moving(Sites(cube, points));
    Eigen::VectorXf direction = Eigen::VectorXf::Zero(8);
    const SiteId first = moving.original_id(0) == 0 ? 0 : 1;
    direction.segment<3>(4 * first).setConstant(float(0.25 / moving.unit()));
    Workers workers(1);
    EnergyPass pass(moving, workers);
    Energy energy;
    ASSERT_TRUE(moving.step(direction, 1, workers));
    EXPECT_FALSE(pass.evaluate(energy));
    moving.step_back();
    EXPECT_TRUE(pass.evaluate(energy));
}

}  // namespace
}  // namespace pcvt::space
