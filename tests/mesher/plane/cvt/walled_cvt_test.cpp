#include "mesher/plane/cvt/walled_cvt.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "mesher/plane/cvt/clipped_cvt.hpp"
#include "mesher/plane/mesh/voronoi.hpp"
#include "mesher/plane/mesh/walled_mesh.hpp"
#include "mesher/plane/symmetry/walled_sites.hpp"
#include "tests/support/cvt_options.hpp"
#include "tests/support/densities.hpp"

namespace pcvt::plane {
namespace {

using testing::kAllWalls;
using testing::to_tolerance;

WalledCvt walled(const Lattice& lattice, Walls walls, int n, const CvtOptions& options,
                 WallCells cells = WallCells::kWhole, std::uint64_t seed = 1) {
    return compute_walled_cvt(lattice, walls, cells, uniform_points(lattice, n, seed), options);
}

/// The sites of a channel with k periods on either side, in a box k times as wide.
Points with_copies(const Points& points, double width, int k) {
    Points all(2, points.cols() * (2 * k + 1));
    for (int copy = 0; copy <= 2 * k; ++copy) {
        for (Eigen::Index s = 0; s < points.cols(); ++s) {
            const double x = points(0, s) - std::floor(points(0, s) / width) * width;
            all.col(copy * points.cols() + s) = Vec2(x + copy * width, points(1, s));
        }
    }
    return all;
}

TEST(WalledCvt, BoxesHaveTheEnergyOfClippedCellsAndAreStationary) {
    for (const int n : {1, 2, 3, 10, 40, 150}) {
        const Lattice box = Lattice::rectangle(1.7, 1);
        const WalledCvt cvt = walled(box, Walls::kXY, n, to_tolerance(1e-12));
        const Points points = points_between_walls(cvt.torus.delaunay, cvt.domain);
        const ClippedEnergy clipped = clipped_energy(box, points);
        EXPECT_NEAR(cvt.torus.run.energy / clipped.value, 1, 1e-14) << n;
        const double unit = clipped.mass.mean() * std::sqrt(box.area() / n);
        EXPECT_LT(clipped.gradient.cwiseAbs().maxCoeff() / unit, 1e-11) << n;
    }
}

TEST(WalledCvt, ChannelsHaveTheCellsOfStrips) {
    for (const int n : {8, 30, 100}) {
        const Lattice channel = Lattice::rectangle(1.2, 1);
        const WalledCvt cvt = walled(channel, Walls::kY, n, to_tolerance(1e-10));
        const Points points = points_between_walls(cvt.torus.delaunay, cvt.domain);
        // The middle period of seven: the sides of the strip are too far away to matter.
        constexpr int kPeriods = 3;
        const Lattice strip = Lattice::rectangle(1.2 * (2 * kPeriods + 1), 1);
        const ClippedEnergy brute = clipped_energy(strip, with_copies(points, 1.2, kPeriods));
        const PeriodicMesh cells = part_between_walls(cell_mesh(cvt.torus.delaunay), cvt.domain);
        ASSERT_EQ(cells.n_faces(), n);
        for (int f = 0; f < n; ++f) {
            Polygon polygon;
            for (int c = cells.face_begin[f]; c < cells.face_begin[f + 1]; ++c) {
                polygon.push_back(cells.point(c));
            }
            EXPECT_NEAR(polygon_area(polygon), brute.mass[kPeriods * n + cells.site[f]], 1e-13);
        }
        EXPECT_LT(
            brute.gradient.middleCols(kPeriods * n, n).cwiseAbs().maxCoeff() / brute.mass.mean(),
            1e-9);
    }
}

TEST(WalledCvt, FewSitesConvergeBetweenAllWalls) {
    for (const Walls walls : kAllWalls) {
        for (int n = 1; n <= 8; ++n) {
            const WalledCvt cvt = walled(Lattice::rectangle(2, 1), walls, n, to_tolerance(1e-9));
            EXPECT_EQ(cvt.torus.run.stop, Stop::kConverged) << walls_row(walls).word << ", " << n;
            EXPECT_GE(cvt.torus.run.energy, cvt.torus.energy_bound);
            EXPECT_EQ(cvt.domain.n_sites, n);
            EXPECT_EQ(cvt.domain.n_on_walls, 0);
        }
    }
}

TEST(WalledCvt, OneSiteInABoxLiesInTheMiddle) {
    const WalledCvt cvt = walled(Lattice::rectangle(3, 1), Walls::kXY, 1, to_tolerance(1e-12));
    const Points points = points_between_walls(cvt.torus.delaunay, cvt.domain);
    EXPECT_NEAR(points(0, 0), 1.5, 1e-12);
    EXPECT_NEAR(points(1, 0), 0.5, 1e-12);
    // 3 x 1: the integral of |p - centre|^2 is w h (w^2 + h^2) / 12.
    EXPECT_NEAR(cvt.torus.run.energy, 3 * 10.0 / 12, 1e-12);
}

TEST(WalledCvt, HalfCellsLieOnWallsAndAreNearerToTheBound) {
    const Lattice box = Lattice::rectangle(1, 1);
    const WalledCvt whole = walled(box, Walls::kXY, 120, to_tolerance(1e-8));
    const WalledCvt half = walled(box, Walls::kXY, 120, to_tolerance(1e-8), WallCells::kHalf);
    EXPECT_GT(half.domain.n_on_walls, 30);
    EXPECT_LT(half.torus.run.energy / half.torus.energy_bound,
              whole.torus.run.energy / whole.torus.energy_bound);
    const Points points = points_between_walls(half.torus.delaunay, half.domain);
    int n_on_walls = 0;
    for (Eigen::Index s = 0; s < points.cols(); ++s) {
        const auto on_wall = [](double x) { return x == 0 || x == 1; };
        n_on_walls += on_wall(points(0, s)) || on_wall(points(1, s));
    }
    EXPECT_EQ(n_on_walls, half.domain.n_on_walls);
    // The clipped energy of the same sites does not use the images.
    EXPECT_NEAR(half.torus.run.energy / clipped_energy(box, points).value, 1, 1e-13);
}

TEST(WalledCvt, DensitiesAreThoseOfTheDomain) {
    // Linear in y: the cells at the upper wall are smaller, and the mass is that of the channel.
    CvtOptions options = to_tolerance(1e-6);
    options.density = shared_density([](const DensityPoint& p) { return 1 + 20 * p.v + 0 * p.y; });
    const Lattice channel = Lattice::rectangle(2, 0.5);
    const WalledCvt cvt = walled(channel, Walls::kY, 200, options);
    ASSERT_TRUE(cvt.torus.density.has_value());
    EXPECT_NEAR(cvt.torus.density->mass, 11 * channel.area(), 1e-10);
    EXPECT_NEAR(cvt.torus.run.energy / cvt.torus.density->expected_energy, 1, 0.1);
    const PeriodicMesh cells = part_between_walls(cell_mesh(cvt.torus.delaunay), cvt.domain);
    double low = 0;
    double high = 0;
    for (int f = 0; f < cells.n_faces(); ++f) {
        (cells.site_points[f].y() < 0.25 ? low : high) += 1;
    }
    EXPECT_GT(high, 1.3 * low);
}

TEST(WalledCvt, ProgressAndCountsGoOnFromRoundToRound) {
    CvtOptions options = to_tolerance(1e-6);
    int n_backwards = 0;
    Progress last;
    options.run.progress = [&](const Progress& progress) {
        n_backwards +=
            progress.iteration < last.iteration || progress.evaluations < last.evaluations;
        last = progress;
        return true;
    };
    const WalledCvt cvt =
        walled(Lattice::rectangle(1, 1), Walls::kXY, 60, options, WallCells::kHalf);
    EXPECT_EQ(n_backwards, 0);
    EXPECT_EQ(last.iteration, cvt.torus.run.iterations);
    EXPECT_NEAR(last.value / cvt.torus.run.energy, 1, 1e-3);
}

TEST(WalledCvt, NumberingByColumnsSortsTheSites) {
    const Lattice box = Lattice::rectangle(1.3, 1);
    const Points points = uniform_points(box, 50, 3);
    CvtOptions options;
    options.run.max_iterations = 0;
    options.numbering = Numbering::kByColumns;
    const WalledCvt cvt = compute_walled_cvt(box, Walls::kY, WallCells::kWhole, points, options);
    const Points sorted = sorted_by_columns(box, points);
    EXPECT_NE(sorted, points);
    EXPECT_TRUE(points_between_walls(cvt.torus.delaunay, cvt.domain).isApprox(sorted, 1e-12));
}

TEST(WalledCvt, HalfCellsThatReachTheOppositeWallAreRefusedWithANumberThatSuffices) {
    const Lattice channel = Lattice::rectangle(12, 1);
    try {
        walled(channel, Walls::kY, 6, to_tolerance(1e-6), WallCells::kHalf);
        FAIL() << "accepted";
    } catch (const InvalidInput& error) {
        EXPECT_STREQ(error.what(),
                     "half cells need rows of sites on both walls, but the cell of a site on one "
                     "wall reaches the opposite one; take at least 24 sites or whole cells");
    }
    EXPECT_NO_THROW(walled(channel, Walls::kY, 24, to_tolerance(1e-6), WallCells::kHalf));
}

TEST(WalledCvt, SlowResultsDoNotDependOnTheNumberOfThreads) {
    CvtOptions options = to_tolerance(1e-6);
    const Lattice box = Lattice::rectangle(1, 2);
    const WalledCvt one = walled(box, Walls::kX, 3000, options);
    options.run.n_threads = 3;
    const WalledCvt three = walled(box, Walls::kX, 3000, options);
    EXPECT_EQ(points_between_walls(one.torus.delaunay, one.domain),
              points_between_walls(three.torus.delaunay, three.domain));
}

TEST(WalledCvt, SitesBeyondAWallAreRefused) {
    Points points(2, 2);
    points << 0.1, 0.5, 0.2, 1.5;
    try {
        compute_walled_cvt(Lattice::rectangle(1, 1), Walls::kY, WallCells::kWhole, points, {});
        FAIL() << "accepted";
    } catch (const InvalidInput& error) {
        EXPECT_STREQ(error.what(),
                     "site 1 lies beyond a wall: its y is not between 0 and the height");
    }
    // Along a channel, sites may lie in any period.
    EXPECT_NO_THROW(compute_walled_cvt(Lattice::rectangle(1, 1), Walls::kX, WallCells::kWhole,
                                       points, to_tolerance(1e-3)));
}

}  // namespace
}  // namespace pcvt::plane
