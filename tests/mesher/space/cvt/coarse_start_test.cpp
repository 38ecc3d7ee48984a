#include "mesher/space/cvt/coarse_start.hpp"

#include <gtest/gtest.h>

#include "tests/support/space_lattices.hpp"

namespace pcvt::space {
namespace {

using testing::kCube;

const Lattice kOblique({1, 0, 0}, {0.37, 0.81, 0}, {0.2, 0.4, 0.9});

/// Starts that have a coarser level reach 31 sites and more.
TEST(SpaceCoarseStart, ReturnsTheRequestedNumberOfDistinctSites) {
    const Lattice thin({100, 0, 0}, {0.3, 1, 0}, {0.2, 0.1, 1});
    for (const Lattice& lattice : {kCube, kOblique, thin}) {
        for (const int n : {1, 2, 30, 31, 32, 100, 237, 238, 400}) {
            const Points points = coarse_start(lattice, n, 1, {});
            ASSERT_EQ(points.cols(), n);
            EXPECT_TRUE(points.allFinite());
            EXPECT_LT(Sites(lattice, points).duplicates().first, 0) << n;
        }
    }
}

TEST(SpaceCoarseStart, WithFewSitesIsRandom) {
    for (const int n : {1, 5, 30}) {
        const Points points = coarse_start(kCube, n, 3, {});
        EXPECT_EQ(points, uniform_points(kCube, n, 3));
    }
}

TEST(SpaceCoarseStart, LeadsToLowerMinimaSlow) {
    for (const Lattice& lattice : {kCube, kOblique}) {
        const auto energy = [&](const Points& start) {
            const auto result = compute_cvt(lattice, start, {{.tolerance = 1e-3}});
            return result.run.energy / body_centred_energy(lattice.volume(), 1500);
        };
        double random = 0;
        double coarse = 0;
        for (std::uint64_t seed = 1; seed <= 3; ++seed) {
            random += energy(uniform_points(lattice, 1500, seed)) / 3;
            coarse += energy(coarse_start(lattice, 1500, seed, {})) / 3;
        }
        EXPECT_LT(coarse - 1, 0.75 * (random - 1));
        EXPECT_GT(coarse, 1);
    }
}

TEST(SpaceCoarseStart, DependsOnTheSeedAndNotOnTheThreads) {
    const Points points = coarse_start(kOblique, 2000, 1, {.n_threads = 1});
    EXPECT_EQ(points, coarse_start(kOblique, 2000, 1, {.n_threads = 3}));
    EXPECT_NE(points, coarse_start(kOblique, 2000, 2, {.n_threads = 1}));
}

TEST(SpaceCoarseStart, ReportsEnergiesOfTheFinestProblemAndItsShare) {
    double last_share = 0;
    double last_energy = 0;
    RunOptions options;
    options.progress = [&](const Progress& progress) {
        EXPECT_GE(progress.share, last_share - 1e-12);
        EXPECT_LE(progress.share, 1 + 1e-12);
        last_share = progress.share;
        last_energy = progress.value;
        return true;
    };
    coarse_start(kCube, 2000, 1, options);
    EXPECT_GT(last_share, 0.95);
    EXPECT_NEAR(last_energy / body_centred_energy(1, 2000), 1.02, 0.02);
}

TEST(SpaceCoarseStart, ReturnsNoSitesAfterACancelledRun) {
    int n_calls = 0;
    RunOptions options;
    options.progress = [&](const Progress&) { return ++n_calls < 40; };
    EXPECT_EQ(coarse_start(kCube, 1000, 1, options).cols(), 0);
    EXPECT_EQ(n_calls, 40);
}

}  // namespace
}  // namespace pcvt::space
