#include "mesher/cvt/residuals.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace pcvt {
namespace {

/// Takes numbers of sites around the number of lanes and the size of a task.
/// @param numbers  numbers a site; the fourth one is zero.
void expect_gradients_over_twice_the_masses(Eigen::Index numbers) {
    std::mt19937_64 random(1);
    std::normal_distribution<double> normal;
    for (const Eigen::Index n : {1, 2, 15, 16, 17, 40, 16'383, 16'384, 16'385, 40'000}) {
        Eigen::VectorXd gradient(numbers * n);
        Eigen::VectorXd mass(n);
        for (double& x : gradient) x = normal(random);
        if (numbers == 4) gradient.reshaped(4, n).row(3).setZero();
        for (double& m : mass) m = 0.5 + std::abs(normal(random));
        constexpr double kSpacing = 0.7;

        double largest = 0;
        double sum = 0;
        for (Eigen::Index s = 0; s < n; ++s) {
            const double residual =
                gradient.segment(numbers * s, numbers).norm() / (2 * mass[s]) / kSpacing;
            largest = std::max(largest, residual);
            sum += residual * residual;
        }
        Workers one(1);
        Workers three(3);
        const Residuals found = residuals(gradient, mass, kSpacing, one);
        EXPECT_NEAR(found.largest / largest, 1, 1e-14) << n;
        EXPECT_NEAR(found.rms / std::sqrt(sum / double(n)), 1, 1e-13) << n;
        const Residuals again = residuals(gradient, mass, kSpacing, three);
        EXPECT_EQ(found.largest, again.largest) << n;
        EXPECT_EQ(found.rms, again.rms) << n;
        Eigen::VectorXf steps;
        steps_to_centroids(gradient, mass, steps);
        ASSERT_EQ(steps.size(), gradient.size());
        for (Eigen::Index k = 0; k < steps.size(); ++k) {
            EXPECT_FLOAT_EQ(steps[k], float(-gradient[k] / (2 * mass[k / numbers])));
        }
    }
}

TEST(Residuals, EqualTheGradientsOverTwiceTheMassesInUnitsOfH) {
    for (const Eigen::Index numbers : {2, 4}) expect_gradients_over_twice_the_masses(numbers);
}

}  // namespace
}  // namespace pcvt
