#include "mesher/plane/energy/residuals.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace pcvt::plane {
namespace {

// Numbers of sites around the number of lanes and the size of a task.
TEST(Residuals, EqualTheGradientsOverTwiceTheMassesInUnitsOfH) {
    std::mt19937_64 random(1);
    std::normal_distribution<double> normal;
    for (const Eigen::Index n : {1, 2, 15, 16, 17, 40, 16'383, 16'384, 16'385, 40'000}) {
        Eigen::VectorXd gradient(2 * n);
        Eigen::VectorXd mass(n);
        for (double& x : gradient) x = normal(random);
        for (double& m : mass) m = 0.5 + std::abs(normal(random));
        constexpr double kSpacing = 0.7;

        double largest = 0;
        double sum = 0;
        for (Eigen::Index s = 0; s < n; ++s) {
            const double residual = gradient.segment<2>(2 * s).norm() / (2 * mass[s]) / kSpacing;
            largest = std::max(largest, residual);
            sum += residual * residual;
        }
        Workers alone(1);
        Workers three(3);
        const Residuals found = residuals(gradient, mass, kSpacing, alone);
        EXPECT_NEAR(found.largest / largest, 1, 1e-14) << n;
        EXPECT_NEAR(found.rms / std::sqrt(sum / double(n)), 1, 1e-13) << n;
        const Residuals again = residuals(gradient, mass, kSpacing, three);
        EXPECT_EQ(found.largest, again.largest) << n;
        EXPECT_EQ(found.rms, again.rms) << n;
    }
}

}  // namespace
}  // namespace pcvt::plane
