#include "mesher/cvt/coarse_levels.hpp"

#include <gtest/gtest.h>

namespace pcvt {
namespace {

constexpr LevelGrowth kPlane{.dimension = 2, .factor = 4, .coarsest = 16, .most_levels = 3};
constexpr LevelGrowth kSpace{.dimension = 3, .factor = 8, .coarsest = 16};

TEST(CoarseLevels, GrowByTheFactorUpToTheFinest) {
    CoarseLevels levels(kPlane, {.n_orbits = 1001}, 5, {});
    EXPECT_EQ(levels.n_coarsest(), 63);
    for (const int n_finer : {251, 1001}) {
        ASSERT_TRUE(levels.next());
        EXPECT_EQ(levels.n_finer(), n_finer);
        EXPECT_EQ(levels.seed(), 5U + static_cast<unsigned>(n_finer));
    }
    EXPECT_FALSE(levels.next());
}

TEST(CoarseLevels, WithFewSitesThereIsOnlyTheFinest) {
    for (const int n : {1, 16}) {
        CoarseLevels levels(kSpace, {.n_orbits = n}, 0, {});
        EXPECT_EQ(levels.n_coarsest(), n);
        EXPECT_FALSE(levels.next());
    }
}

TEST(CoarseLevels, ScaleEnergiesToTheFinest) {
    for (const LevelGrowth& growth : {kPlane, kSpace}) {
        Progress reported;
        const RunOptions options{.progress = [&](const Progress& progress) {
            reported = progress;
            return true;
        }};
        const int n = static_cast<int>(10 * growth.factor);
        CoarseLevels levels(growth, {.n_orbits = n, .orbit_size = 2}, 0, options);
        ASSERT_TRUE(levels.next());
        EXPECT_TRUE(levels.run().progress({.value = 100, .rms_residual = 1}));
        EXPECT_NEAR(reported.value, 25, 1e-13) << growth.dimension;
        EXPECT_EQ(reported.share, 0);
    }
}

TEST(CoarseLevels, EndARunAtTheToleranceOrWhereTheCallbackCancels) {
    bool goes_on = true;
    const RunOptions options{.progress = [&](const Progress&) { return goes_on; }};
    CoarseLevels levels(kSpace, {.n_orbits = 80}, 0, options);
    ASSERT_TRUE(levels.next());
    const RunOptions run = levels.run();
    EXPECT_TRUE(run.progress({.rms_residual = 2 * kCoarseTolerance}));
    EXPECT_FALSE(run.progress({.rms_residual = kCoarseTolerance / 2}));
    EXPECT_FALSE(levels.cancelled());
    goes_on = false;
    EXPECT_FALSE(run.progress({.rms_residual = 1}));
    EXPECT_TRUE(levels.cancelled());
}

}  // namespace
}  // namespace pcvt
