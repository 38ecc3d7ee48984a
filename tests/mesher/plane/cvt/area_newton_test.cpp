#include "mesher/plane/cvt/area_newton.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <random>

#include "tests/support/case_count.hpp"
#include "tests/support/clipped_power_cells.hpp"
#include "tests/support/lattices.hpp"
#include "tests/support/special_sites.hpp"

namespace pcvt::plane {
namespace {

using testing::lattices;
using testing::random_lattice;

/// Areas of cells whose diameters are lognormally distributed, with the sum of the domain's area.
Eigen::VectorXd lognormal_areas(const MovingDelaunay& delaunay, double spread,
                                std::mt19937_64& random) {
    std::normal_distribution<double> normal;
    const double sigma = std::sqrt(std::log(1 + spread * spread));
    Eigen::VectorXd areas(delaunay.n_sites());
    for (double& a : areas) a = std::exp(2 * sigma * normal(random));
    return areas * (delaunay.frame().ax * delaunay.frame().by / areas.sum());
}

/// Sites in clusters, in rows, on a grid, or uniform.
Points hard_points(const Lattice& lattice, int n, int kind, std::mt19937_64& random) {
    Points points = uniform_points(lattice, n, random());
    std::normal_distribution<double> normal;
    const int n_columns = static_cast<int>(std::ceil(std::sqrt(n)));
    for (int s = 0; s < n; ++s) {
        const Vec2 u = lattice.to_lattice(points.col(s));
        if (kind == 1) {
            const Vec2 centre(0.2 * double(s % 4), 0.37 * double(s % 3));
            points.col(s) =
                lattice.to_position(centre + 0.01 * Vec2{normal(random), normal(random)});
        } else if (kind == 2) {
            points.col(s) = lattice.to_position({(s + 0.5 * u.x()) / n, 0.3 + 1e-6 * u.y()});
        } else if (kind == 3) {
            points.col(s) = lattice.to_position(
                {double(s % n_columns) / n_columns, double(s / n_columns) / n_columns});
        }
    }
    return points;
}

struct Tally {
    int n_rounding = 0;
    double worst_of_mean = 0;
    int most_steps = 0;
};

void solve_hard_case(int k, int most_sites, Tally& tally) {
    std::mt19937_64 random(static_cast<std::uint64_t>(k));
    const auto named = lattices();
    const int n = 1 + static_cast<int>(random() % most_sites);
    const Lattice lattice =
        k % 3 == 0 ? random_lattice(random) : named[(k / 3) % named.size()].lattice;
    const Sites sites(lattice, hard_points(lattice, n, k % 4, random));
    const MovingDelaunay delaunay(sites);
    const double spread = std::array{1e-9, 0.1, 0.42, 0.8}[(k / 4) % 4];
    const Eigen::VectorXd areas = lognormal_areas(delaunay, spread, random);
    Workers workers(1);
    AreaNewton newton(delaunay, workers);
    const SizeFigures figures = newton.solve(areas, 1e-10);
    const double error = (newton.sizes() - areas).cwiseAbs().maxCoeff();
    tally.worst_of_mean = std::max(tally.worst_of_mean, error / areas.mean());
    tally.most_steps = std::max(tally.most_steps, figures.newton_steps);
    tally.n_rounding += figures.largest_relative_error > 1e-10;
    ASSERT_TRUE(figures.converged)
        << "case " << k << " n " << n << " error " << figures.largest_relative_error << " rounding "
        << figures.rounding << " steps " << figures.newton_steps;
    if (k % 10 != 0 || n > 60) return;
    // The masses are those of the polygons of all images.
    const double unit = delaunay.unit() * delaunay.unit();
    Eigen::VectorXd weights(n);
    for (int s = 0; s < n; ++s) weights[delaunay.original_id(s)] = newton.weights()[s] * unit;
    const auto cells = testing::clipped_power_cells(sites, weights);
    for (int s = 0; s < n; ++s) {
        const double area = testing::polygon_moments(cells[delaunay.original_id(s)]).area;
        ASSERT_NEAR(area / unit, areas[s], 1e-8 * areas[s]) << k;
    }
}

// Law 1. PCVT_AREA_CASES=10000 in the environment runs as many cases.
TEST(AreaNewton, ReachesTheAreasInRandomHardCases) {
    const int n = testing::case_count("PCVT_AREA_CASES", 300);
    Tally tally;
    for (int k = 0; k < n && !HasFatalFailure(); ++k) solve_hard_case(k, 500, tally);
    EXPECT_LT(tally.worst_of_mean, 1e-9);
    EXPECT_LT(tally.n_rounding, 1 + n / 50);
    std::printf("%d cases: error %.1e of the mean area, %d above 1e-10 by rounding, %d steps\n", n,
                tally.worst_of_mean, tally.n_rounding, tally.most_steps);
}

TEST(AreaNewton, AThousandGrainsNeedTwelveStepsAtMost) {
    const Lattice unit = Lattice::rectangle(1, 1);
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        const MovingDelaunay delaunay(Sites(unit, uniform_points(unit, 1000, seed)));
        Workers workers(1);
        std::mt19937_64 random(seed);
        AreaNewton newton(delaunay, workers);
        const SizeFigures figures = newton.solve(lognormal_areas(delaunay, 0.42, random), 1e-10);
        EXPECT_LE(figures.largest_relative_error, 1e-10);
        EXPECT_LE(figures.newton_steps, 12);
        // Law 2.
        EXPECT_NEAR(newton.weights().sum(), 0, 1e-10);
        // The last weights are a good start.
        EXPECT_EQ(newton.solve(newton.sizes(), 1e-10).newton_steps, 0);
    }
}

// Law 2.
TEST(AreaNewton, EqualAreasOnALatticeNeedNoWeights) {
    for (const auto& [name, lattice] : lattices()) {
        const MovingDelaunay delaunay(testing::grid_sites(lattice, 5, 7, 0, 0));
        Workers workers(1);
        AreaNewton newton(delaunay, workers);
        const double total = delaunay.frame().ax * delaunay.frame().by;
        const SizeFigures figures = newton.solve(Eigen::VectorXd::Constant(35, total / 35), 1e-12);
        EXPECT_EQ(figures.newton_steps, 0) << name;
        EXPECT_EQ(newton.weights(), Eigen::VectorXd::Zero(35)) << name;
    }
}

// Law 3.
TEST(AreaNewton, EveryBitIsTheSameForAnyNumberOfWorkers) {
    const Lattice unit = Lattice::rectangle(1, 1);
    const MovingDelaunay delaunay(Sites(unit, uniform_points(unit, 20'000, 1)));
    std::mt19937_64 random(1);
    const Eigen::VectorXd areas = lognormal_areas(delaunay, 0.42, random);
    Workers one(1);
    Workers three(3);
    AreaNewton first(delaunay, one);
    AreaNewton second(delaunay, three);
    EXPECT_EQ(first.solve(areas, 1e-10).trials, second.solve(areas, 1e-10).trials);
    EXPECT_EQ(first.weights(), second.weights());
    EXPECT_EQ(first.sizes(), second.sizes());
}

}  // namespace
}  // namespace pcvt::plane
