#include "mesher/plane/cvt/clipped_cvt.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "mesher/base/error.hpp"
#include "mesher/plane/cvt/cvt.hpp"
#include "tests/support/lattices.hpp"

namespace pcvt::plane {
namespace {

using testing::lattices;

double nearest_squared(const Points& points, const Vec2& p) {
    return (points.colwise() - p).colwise().squaredNorm().minCoeff();
}

/// Checks law (1) against the area of the domain and law (2) by brute force.
TEST(ClippedCvt, CellsFillTheDomainAndHoldTheirNearestPoints) {
    for (const auto& [name, lattice] : lattices()) {
        for (const int n : {1, 2, 3, 7, 150}) {
            const Points points = uniform_points(lattice, n, 7);
            const std::vector<ClippedCell> cells = clipped_cells(lattice, points);
            double area = 0;
            for (int s = 0; s < n; ++s) {
                area += polygon_area(cells[s].polygon);
                for (const Vec2& corner : cells[s].polygon) {
                    const double own = (corner - points.col(s)).squaredNorm();
                    EXPECT_LE(own, nearest_squared(points, corner) + 1e-12 * lattice.area())
                        << name << " n = " << n;
                }
            }
            EXPECT_NEAR(area / lattice.area(), 1, 1e-12) << name << " n = " << n;
        }
    }
}

TEST(ClippedCvt, OnlyCellsAtTheBorderMeetTheBorder) {
    Points grid(2, 25);
    for (int s = 0; s < 25; ++s) grid.col(s) << (s % 5 + 0.5) / 5, (s / 5 + 0.5) / 5;
    const std::vector<ClippedCell> cells = clipped_cells(Lattice::rectangle(1, 1), grid);
    for (int s = 0; s < 25; ++s) {
        const bool inner = s % 5 > 0 && s % 5 < 4 && s / 5 > 0 && s / 5 < 4;
        EXPECT_EQ(cells[s].meets_border, !inner) << s;
    }
}

/// The energy of one site at the centre of the parallelogram is area (|a|^2 + |b|^2) / 12.
TEST(ClippedCvt, OneSiteHasTheWholeDomain) {
    for (const auto& [name, lattice] : lattices()) {
        const Vec2 middle = lattice.to_position({0.5, 0.5});
        const double whole =
            lattice.area() * (lattice.a().squaredNorm() + lattice.b().squaredNorm()) / 12;
        EXPECT_NEAR(clipped_energy(lattice, middle).value / whole, 1, 1e-12) << name;
        EXPECT_NEAR(clipped_energy(lattice, middle).mass[0] / lattice.area(), 1, 1e-12) << name;
        const ClippedCvt cvt = compute_clipped_cvt(lattice, uniform_points(lattice, 1, 3), {1e-9});
        EXPECT_EQ(cvt.run.stop, Stop::kConverged) << name;
        EXPECT_NEAR(cvt.run.energy / whole, 1, 1e-12) << name;
    }
}

TEST(ClippedCvt, TheEnergyIsTheIntegralOverTheDomain) {
    const Lattice lattice({1, 0}, {0.37, 0.81});
    const Points points = uniform_points(lattice, 12, 4);
    constexpr int kSteps = 700;
    double sum = 0;
    for (int i = 0; i < kSteps; ++i) {
        for (int j = 0; j < kSteps; ++j) {
            sum += nearest_squared(points, lattice.to_position(Vec2(i + 0.5, j + 0.5) / kSteps));
        }
    }
    const double integral = sum * lattice.area() / (kSteps * kSteps);
    EXPECT_NEAR(clipped_energy(lattice, points).value / integral, 1, 1e-5);
}

TEST(ClippedCvt, TheGradientAgreesWithDifferencesOfTheEnergy) {
    for (const auto& [name, lattice] : lattices()) {
        Points points = uniform_points(lattice, 9, 5);
        const ClippedEnergy at = clipped_energy(lattice, points);
        const double step = 1e-5 * std::sqrt(lattice.area() / 9);
        for (double& x : points.reshaped()) {
            const double here = x;
            x = here + step;
            const double after = clipped_energy(lattice, points).value;
            x = here - step;
            const double before = clipped_energy(lattice, points).value;
            x = here;
            const auto k = &x - points.data();
            const double scale = at.gradient.cwiseAbs().maxCoeff();
            EXPECT_NEAR(at.gradient.data()[k], (after - before) / (2 * step), 1e-6 * scale) << name;
        }
    }
}

/// Two sites halve the unit square; their energy is 2 (1/2)(1 + 1/4)/12.
TEST(ClippedCvt, TwoSitesHalveTheSquare) {
    const Lattice unit = Lattice::rectangle(1, 1);
    const ClippedCvt cvt = compute_clipped_cvt(unit, uniform_points(unit, 2, 1), {1e-10});
    EXPECT_EQ(cvt.run.stop, Stop::kConverged);
    EXPECT_NEAR(cvt.run.energy, 1.25 / 12, 1e-12);
    EXPECT_NEAR(clipped_energy(unit, cvt.sites).value, cvt.run.energy, 1e-15);
}

TEST(ClippedCvt, ConvergesToAMinimumAboveTheHexagonalBound) {
    for (const auto& [name, lattice] : lattices()) {
        const Points start = uniform_points(lattice, 60, 2);
        const ClippedCvt cvt = compute_clipped_cvt(lattice, start, {1e-6});
        EXPECT_EQ(cvt.run.stop, Stop::kConverged) << name;
        EXPECT_LE(cvt.run.residual, 1e-6) << name;
        EXPECT_LT(cvt.run.energy, clipped_energy(lattice, start).value) << name;
        EXPECT_GT(cvt.run.energy, hexagonal_bound(lattice.area(), 60)) << name;
    }
}

TEST(ClippedCvt, ProgressIsReportedInTheUsersUnitAndCancels) {
    const Lattice lattice = Lattice::rectangle(1000, 1000);
    const Points start = uniform_points(lattice, 20, 2);
    double first = 0;
    const ClippedCvt cvt = compute_clipped_cvt(lattice, start, {1e-6, -1, [&](const Progress& p) {
                                                                    if (p.iteration == 0)
                                                                        first = p.value;
                                                                    return p.iteration < 3;
                                                                }});
    EXPECT_EQ(cvt.run.stop, Stop::kCancelled);
    EXPECT_NEAR(first / clipped_energy(lattice, start).value, 1, 1e-12);
}

TEST(ClippedCvt, RefusesPointsWithoutCells) {
    const Lattice unit = Lattice::rectangle(1, 1);
    EXPECT_THROW(clipped_cells(unit, Points(2, 0)), InvalidInput);
    Points points = uniform_points(unit, 5, 1);
    points.col(3) = Vec2(1.2, 0.5);
    EXPECT_THROW(clipped_cells(unit, points), InvalidInput);
    points.col(3) = Vec2(std::nan(""), 0.5);
    EXPECT_THROW(clipped_energy(unit, points), InvalidInput);
    points.col(3) = points.col(1);
    try {
        compute_clipped_cvt(unit, points, {});
        FAIL();
    } catch (const DuplicateSites& error) {
        EXPECT_EQ(error.first(), 1);
        EXPECT_EQ(error.second(), 3);
    }
}

}  // namespace
}  // namespace pcvt::plane
