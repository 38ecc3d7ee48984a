#include "mesher/space/search/lattice_stability.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "mesher/space/energy/energy_pass.hpp"
#include "tests/support/hessian_by_differences.hpp"

namespace pcvt::space {
namespace {

const Eigen::Matrix3d kCubePeriods = Eigen::Matrix3d::Identity();

/// The error of differences over 1e-5 h; the third derivative jumps where facets vanish.
constexpr double kDifferences = 3e-5;

Eigen::Matrix3d sheared_period() {
    Eigen::Matrix3d period;
    period << 1, 0.3, 0.1, 0, 1.1, 0.2, 0, 0, 1.3;
    return period;
}

/// The gradient of F in the order of the sites, 3 n numbers. The period vectors are reduced, the
/// first lies along x and the second in the plane x, y, so that frame and space agree up to a unit.
Eigen::VectorXd gradient_at(const Eigen::Matrix3d& period, const Points& points) {
    const Lattice lattice(period.col(0), period.col(1), period.col(2));
    MovingTetrahedra moving(Sites(lattice, points));
    Workers workers(1);
    EnergyPass pass(moving, workers);
    Energy energy;
    EXPECT_TRUE(pass.evaluate(energy));
    Eigen::VectorXd gradient(3 * points.cols());
    for (SiteId s = 0; s < moving.n_sites(); ++s) {
        gradient.segment<3>(3 * Eigen::Index{moving.original_id(s)}) =
            energy.gradient.segment<3>(MovingTetrahedra::kNumbersPerSite * Eigen::Index{s});
    }
    return gradient;
}

double smallest_by_differences(const LatticePattern& pattern) {
    const double step = 1e-5 * std::cbrt(pattern.basis.determinant());
    const auto gradient = [&](const Points& points) { return gradient_at(pattern.period, points); };
    return testing::smallest_eigenvalue(
        testing::hessian_by_differences(pattern_points(pattern), step, gradient), 3);
}

/// Law (1), at minima, saddles and lattices whose cells have six to fourteen faces.
TEST(SpaceStability, AgreesWithDifferencesOfTheGradient) {
    for (const Eigen::Matrix3d& period : {kCubePeriods, sheared_period()}) {
        for (const int n : {2, 3, 4, 5, 7, 10, 12}) {
            const LatticePattern pattern = best_lattice(period, n);
            EXPECT_NEAR(*lattice_stability(pattern).smallest, smallest_by_differences(pattern),
                        kDifferences)
                << n;
        }
        const LatticePattern layers = lattice_pattern(period, {.a = 2, .d = 1, .f = 4, .e = 3});
        EXPECT_NEAR(*lattice_stability(layers).smallest, smallest_by_differences(layers),
                    kDifferences);
    }
}

TEST(SpaceStability, BodyCentredLatticesAreMinimaAndCubesSaddles) {
    for (const int n : {2, 16, 54}) {
        EXPECT_EQ(lattice_stability(best_lattice(kCubePeriods, n)).minimum, Minimum::kYes) << n;
    }
    for (const int k : {2, 3}) {
        const LatticePattern cubes = lattice_pattern(kCubePeriods, {.a = k, .d = k, .f = k});
        EXPECT_EQ(lattice_stability(cubes).minimum, Minimum::kNo) << k;
    }
}

TEST(SpaceStability, OneSiteHasOnlyTheTranslations) {
    const LatticeStability stability = lattice_stability(best_lattice(kCubePeriods, 1));
    EXPECT_EQ(stability.minimum, Minimum::kYes);
    EXPECT_FALSE(stability.smallest.has_value());
}

TEST(SpaceStability, DependsNeitherOnTheUnitNorOnTheHandOfThePeriods) {
    for (const int n : {5, 12}) {
        const double smallest = *lattice_stability(best_lattice(sheared_period(), n)).smallest;
        for (const double unit : {1e-6, -1.0, 1e6}) {
            const LatticePattern scaled = best_lattice(unit * sheared_period(), n);
            EXPECT_NEAR(*lattice_stability(scaled).smallest, smallest, 1e-9) << unit;
        }
    }
}

}  // namespace
}  // namespace pcvt::space
