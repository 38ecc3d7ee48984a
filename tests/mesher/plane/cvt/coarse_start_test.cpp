#include "mesher/plane/cvt/coarse_start.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "mesher/plane/cvt/walled_cvt.hpp"
#include "mesher/plane/density/density_survey.hpp"
#include "mesher/plane/mesh/valence.hpp"
#include "tests/support/cvt_options.hpp"
#include "tests/support/densities.hpp"

namespace pcvt::plane {
namespace {

using testing::kAllWalls;

/// The fraction of the cells of a result whose valence is not six.
double defects(const CvtResult& result) {
    const TorusTriangulation& t = result.delaunay.triangulation();
    std::vector<int> valence(static_cast<std::size_t>(t.n_sites()));
    for (int h = 0; h < t.n_halfedges(); ++h) ++valence[t.corner(h).site];
    return 1 - double(std::count(valence.begin(), valence.end(), 6)) / t.n_sites();
}

// Two neighbours of a hexagonal arrangement are an edge apart, and each cell has the area
// sqrt(3) / 2 of the square of that edge.
TEST(CoarseStart, KnowsTheSpacingOfAHexagonalArrangement) {
    const Lattice cell({1, 0}, {0.5, std::sqrt(0.75)});
    EXPECT_NEAR(kSpacingPerEdge, Sites(cell, Points::Zero(2, 1)).spacing(), 1e-15);
}

TEST(CoarseStart, ReturnsTheRequestedNumberOfDistinctSites) {
    const Lattice lattice({2, 0}, {0.5, 1});
    for (const int n : {1, 2, 3, 16, 17, 63, 64, 65, 255, 256, 257, 1000}) {
        const Points points = coarse_start(lattice, n, 1, {});
        ASSERT_EQ(points.cols(), n);
        const Sites sites(lattice, points);
        EXPECT_LT(sites.duplicates().first, 0);
    }
}

TEST(CoarseStart, ReturnsDistinctSitesBetweenWalls) {
    const Lattice lattice = Lattice::rectangle(3, 1);
    for (const Walls walls : kAllWalls) {
        for (const int n : {1, 2, 3, 16, 17, 63, 64, 65, 255, 1000}) {
            const Points points = coarse_start(lattice, n, 1, {}, walls);
            ASSERT_EQ(points.cols(), n);
            EXPECT_LT(Sites(lattice, points).duplicates().first, 0);
            for (int axis = 0; axis < 2; ++axis) {
                if (!has_walls_across(walls, axis)) continue;
                EXPECT_GT(points.row(axis).minCoeff(), 0);
                EXPECT_LT(points.row(axis).maxCoeff(), side_length(lattice, axis));
            }
        }
    }
}

TEST(CoarseStart, LeadsToLowerMinimaBetweenWallsSlow) {
    const Lattice lattice = Lattice::rectangle(2, 1);
    for (const Walls walls : {Walls::kY, Walls::kXY}) {
        for (const WallCells cells : {WallCells::kWhole, WallCells::kHalf}) {
            if (walls == Walls::kXY && cells == WallCells::kHalf) continue;
            CvtOptions options;
            options.run.tolerance = 1e-4;
            const auto energy = [&](const Points& start) {
                return compute_walled_cvt(lattice, walls, cells, start, options).torus.run.energy;
            };
            double random = 0;
            double coarse = 0;
            for (std::uint64_t seed = 1; seed <= 3; ++seed) {
                random += energy(uniform_points(lattice, 1000, seed));
                coarse += energy(coarse_start(lattice, 1000, seed, {}, walls));
            }
            EXPECT_LT(coarse, random * (1 - 1e-3)) << walls_row(walls).word;
        }
    }
}

TEST(CoarseStart, SitesNearWallsAreThoseOfTheNextFinerCells) {
    // The sites of the last level lie as densely beside a wall as elsewhere.
    const Lattice lattice = Lattice::rectangle(1, 1);
    const Points points = coarse_start(lattice, 4000, 1, {}, Walls::kXY);
    const double h = std::sqrt(1.0 / 4000);
    int n_beside = 0;
    for (Eigen::Index s = 0; s < points.cols(); ++s) n_beside += points(1, s) < 3 * h;
    EXPECT_NEAR(n_beside * h / 3, 1, 0.12);
}

TEST(CoarseStart, DependsOnTheSeedAndNotOnTheThreads) {
    const Lattice lattice = Lattice::rectangle(1, 1);
    const Points points = coarse_start(lattice, 40000, 1, {});
    EXPECT_EQ(points, coarse_start(lattice, 40000, 1, {{.n_threads = 2}}));
    EXPECT_NE(points, coarse_start(lattice, 40000, 2, {}));
}

TEST(CoarseStart, LeadsToLowerMinimaWithFewerDefects) {
    const Lattice lattice = Lattice::rectangle(1, 1);
    CvtOptions options;
    options.run.tolerance = 1e-4;
    const CvtResult from_random = compute_cvt(lattice, uniform_points(lattice, 4000, 1), options);
    const CvtResult from_coarse = compute_cvt(lattice, coarse_start(lattice, 4000, 1, {}), options);
    EXPECT_LT(from_coarse.run.energy, from_random.run.energy * (1 - 1e-3));
    EXPECT_LT(defects(from_coarse), 0.04);
    EXPECT_GT(defects(from_random), 0.07);
}

TEST(CoarseStart, LeadsToLowerMinimaOfSmoothDensitiesToo) {
    const Lattice lattice = Lattice::rectangle(1, 1);
    CvtOptions options;
    options.density = testing::ridge_density();
    options.run.tolerance = 1e-3;
    CoarseStartOptions coarse;
    coarse.density = options.density;
    const CvtResult from_random =
        compute_cvt(lattice, graded_points(lattice, *options.density, 4000, 1), options);
    const CvtResult from_coarse =
        compute_cvt(lattice, coarse_start(lattice, 4000, 1, coarse), options);
    EXPECT_LT(from_coarse.run.energy, from_random.run.energy * (1 - 1e-3));
    EXPECT_LT(from_coarse.run.evaluations, from_random.run.evaluations);
    EXPECT_LT(from_coarse.density->spacing_deviation, 0.02);
}

TEST(CoarseStart, CoarseCellsResolveDensitiesThatChangeSlowly) {
    const Lattice unit = Lattice::rectangle(1, 1);
    for (const double scale : {1.0, 1e-6, 1e6}) {
        const Lattice lattice = Lattice::rectangle(scale, scale);
        EXPECT_TRUE(is_resolved_by_coarse_cells(lattice, testing::smooth_density(), 1000));
        EXPECT_FALSE(is_resolved_by_coarse_cells(lattice, testing::smooth_density(), 2));
        // At most 28 periods^-1.
        EXPECT_TRUE(is_resolved_by_coarse_cells(lattice, testing::ridge_density(), 4000));
        EXPECT_FALSE(is_resolved_by_coarse_cells(lattice, testing::ridge_density(), 500));
    }
    EXPECT_FALSE(is_resolved_by_coarse_cells(unit, testing::ramp_density(), 100000));
    // The coarsest cells are longer than the shorter period.
    EXPECT_FALSE(
        is_resolved_by_coarse_cells(Lattice::rectangle(100, 1), testing::smooth_density(), 1000));
}

TEST(CoarseStart, StopsWhenCancelled) {
    CoarseStartOptions options;
    int n_calls = 0;
    options.run.progress = [&](const Progress&) { return ++n_calls < 5; };
    EXPECT_EQ(coarse_start(Lattice::rectangle(1, 1), 1000, 1, options).cols(), 0);
    EXPECT_EQ(n_calls, 5);
}

}  // namespace
}  // namespace pcvt::plane
