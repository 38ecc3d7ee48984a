#include "mesher/finite_volume/beltrami_flow.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace pcvt {
namespace {

const space::Lattice kLattices[] = {
    space::Lattice::box(1, 1, 1), space::Lattice::box(2, 1, 1),
    space::Lattice({1, 0.2, 0.1}, {-0.3, 0.9, 0.2}, {2.4, 0.3, 1.2})};

space::Vec3 random_point(std::mt19937& random) {
    std::uniform_real_distribution<double> entry(-2, 2);
    return {entry(random), entry(random), entry(random)};
}

/// Law (1).
TEST(BeltramiFlow, HasThePeriodOfTheLattice) {
    std::mt19937 random(1);
    for (const space::Lattice& lattice : kLattices) {
        const BeltramiFlow flow(lattice);
        for (int k = 0; k < 100; ++k) {
            const space::Vec3 p = random_point(random);
            const space::Vec3 u = flow.velocity(p);
            EXPECT_LE(u.norm(), 1 + 1e-12);
            for (const space::Vec3& period : lattice.periods()) {
                EXPECT_LT((flow.velocity(p + period) - u).norm(), 1e-12);
            }
        }
    }
}

/// Law (2).
TEST(BeltramiFlow, IsAnEigenfunctionOfCurl) {
    std::mt19937 random(2);
    const double step = 1e-5;
    for (const space::Lattice& lattice : kLattices) {
        const BeltramiFlow flow(lattice);
        for (int k = 0; k < 100; ++k) {
            const space::Vec3 p = random_point(random);
            Eigen::Matrix3d derivative;
            for (int x = 0; x < 3; ++x) {
                derivative.col(x) = (flow.velocity(p + step * space::Vec3::Unit(x)) -
                                     flow.velocity(p - step * space::Vec3::Unit(x))) /
                                    (2 * step);
            }
            const space::Vec3 curl(derivative(2, 1) - derivative(1, 2),
                                   derivative(0, 2) - derivative(2, 0),
                                   derivative(1, 0) - derivative(0, 1));
            EXPECT_NEAR(derivative.trace(), 0, 1e-8);
            EXPECT_LT((curl + std::sqrt(flow.rate()) * flow.velocity(p)).norm(), 1e-7);
        }
    }
    EXPECT_NEAR(BeltramiFlow(kLattices[0]).rate(), 4 * std::numbers::pi * std::numbers::pi, 1e-12);
}

}  // namespace
}  // namespace pcvt
