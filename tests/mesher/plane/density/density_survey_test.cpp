#include "mesher/plane/density/density_survey.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "tests/support/densities.hpp"
#include "tests/support/lattices.hpp"

namespace pcvt::plane {
namespace {

using ::testing::HasSubstr;

TEST(DensitySurvey, DrawsSitesFromTheRootOfTheDensity) {
    // The density is 100 on the left half and 1 on the right half: 10 of 11 sites lie on the left.
    const Density density =
        shared_density([](const DensityPoint& p) { return p.u < 0.5 ? 100.0 : 1.0; });
    const int n = 20000;
    for (const auto& [name, lattice] : testing::lattices()) {
        const Points points = graded_points(lattice, density, n, 3);
        int n_left = 0;
        for (int s = 0; s < n; ++s) {
            const Vec2 u = lattice.to_lattice(points.col(s));
            ASSERT_TRUE(u.minCoeff() > -1e-6 && u.maxCoeff() < 1 + 1e-6) << name;
            n_left += u.x() < 0.5;
        }
        EXPECT_NEAR(double(n_left) / n, 10.0 / 11, 0.01) << name;
    }
}

TEST(DensitySurvey, DrawsTheSameSitesFromTheSameSeedOnly) {
    const Lattice lattice = Lattice::rectangle(1, 1);
    const Density density = testing::smooth_density();
    EXPECT_EQ(graded_points(lattice, density, 50, 1), graded_points(lattice, density, 50, 1));
    EXPECT_NE(graded_points(lattice, density, 50, 1), graded_points(lattice, density, 50, 2));
}

TEST(DensitySurvey, SamplesTheSeam) {
    const Density zero_at_seam = shared_density([](const DensityPoint& p) { return p.u; });
    try {
        DensitySurvey(Lattice::rectangle(3, 1), zero_at_seam, 16);
        FAIL();
    } catch (const BadDensity& error) {
        EXPECT_THAT(error.what(), HasSubstr("the density is 0 at x = 0, y = 0"));
    }
}

TEST(DensitySurvey, RejectsTooMuchContrast) {
    const Density steep = shared_density([](const DensityPoint& p) { return std::exp(-60 * p.v); });
    EXPECT_THROW(DensitySurvey(Lattice::rectangle(1, 1), steep, 256), BadDensity);
}

TEST(DensitySurvey, EstimatesTheScaleOfTheDensity) {
    const Density density = shared_density([](const DensityPoint&) { return 1e40; });
    const DensitySurvey survey(Lattice::rectangle(1, 1), density, 16);
    EXPECT_GE(survey.unit(), 1e40);
    EXPECT_LE(survey.unit(), 2e40);
    EXPECT_NEAR(survey.mean_root_squared() / 1e40, 1, 1e-12);
}

TEST(DensitySurvey, SteepestChangeIsThatOfTheLogarithm) {
    constexpr double kTurn = 2 * std::numbers::pi;
    const auto steepest = [](const Lattice& lattice, const Density& density) {
        return DensitySurvey(lattice, density, kSurveyResolution).steepest();
    };
    const Density smooth = testing::smooth_density();
    EXPECT_NEAR(steepest(Lattice::rectangle(1, 4), smooth), kTurn, 1e-2);
    EXPECT_NEAR(steepest(Lattice::rectangle(4, 0.5), smooth), kTurn / 0.5, 1e-2);
    EXPECT_NEAR(steepest(Lattice({3, 4}, {-4, 3}), smooth), kTurn / 5, 1e-2);
    // The jump at the seam.
    EXPECT_GT(steepest(Lattice::rectangle(1, 1), testing::ramp_density()), 1000);
}

TEST(DensitySurvey, IntegratesSmoothDensitiesAndJumpsAtBreakLines) {
    const Lattice lattice({2, 0}, {0.7, 1.5});
    // I_0(1)^2, where I_0 is the modified Bessel function.
    EXPECT_NEAR(integral(lattice, testing::smooth_density()) / 3,
                std::pow(std::cyl_bessel_i(0.0, 1.0), 2), 1e-12);
    EXPECT_NEAR(integral(lattice, testing::ramp_density()), 3 * 50.5, 1e-11);
    Density jump = shared_density([](const DensityPoint& p) { return p.u < 0.3 ? 5.0 : 1.0; });
    EXPECT_GT(std::abs(integral(lattice, jump) - 3 * 2.2), 1e-4);
    jump.u_breaks = {0.3};
    EXPECT_NEAR(integral(lattice, jump), 3 * 2.2, 1e-12);
}

}  // namespace
}  // namespace pcvt::plane
