#include "mesher/finite_volume/decaying_flow.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "mesher/plane/geometry/sites.hpp"
#include "tests/support/lattices.hpp"

namespace pcvt {
namespace {

using testing::lattices;

/// Derivatives by central differences of width `step`.
class Differences {
   public:
    Differences(const DecayingFlow& flow, double step) : flow_(flow), step_(step) {}
    double divergence(const plane::Vec2& p) const { return along(p, 0).x() + along(p, 1).y(); }
    double curl(const plane::Vec2& p) const { return along(p, 0).y() - along(p, 1).x(); }
    double laplacian_of_curl(const plane::Vec2& p) const {
        const plane::Vec2 x(step_, 0);
        const plane::Vec2 y(0, step_);
        return (curl(p + x) + curl(p - x) + curl(p + y) + curl(p - y) - 4 * curl(p)) /
               (step_ * step_);
    }

   private:
    plane::Vec2 along(const plane::Vec2& p, int axis) const {
        const plane::Vec2 d = step_ * plane::Vec2(axis == 0, axis == 1);
        return (flow_.velocity(p + d) - flow_.velocity(p - d)) / (2 * step_);
    }
    const DecayingFlow& flow_;
    double step_;
};

TEST(DecayingFlow, HasThePeriodOfTheLatticeAndNoDivergence) {
    for (const auto& [name, lattice] : lattices()) {
        const DecayingFlow flow(lattice);
        const plane::Points points = uniform_points(lattice, 20, 3);
        const double step = 1e-4 / std::sqrt(flow.rate());
        for (const plane::Vec2 p : points.colwise()) {
            const plane::Vec2 image = p + lattice.translation({2, -1});
            EXPECT_LT((flow.velocity(image) - flow.velocity(p)).norm(), 1e-11) << name;
            EXPECT_LT(std::abs(Differences(flow, step).divergence(p)) * step, 1e-11) << name;
        }
    }
}

TEST(DecayingFlow, ItsCurlDecaysWithTheRate) {
    for (const auto& [name, lattice] : lattices()) {
        const DecayingFlow flow(lattice);
        const Differences by_differences(flow, 1e-3 / std::sqrt(flow.rate()));
        const plane::Points points = uniform_points(lattice, 20, 4);
        for (const plane::Vec2 p : points.colwise()) {
            const double wanted = -flow.rate() * by_differences.curl(p);
            EXPECT_NEAR(by_differences.laplacian_of_curl(p), wanted,
                        1e-4 * std::pow(flow.rate(), 1.5))
                << name;
        }
    }
}

TEST(DecayingFlow, TheLargestSpeedIsOne) {
    for (const auto& [name, lattice] : lattices()) {
        const DecayingFlow flow(lattice);
        double largest = 0;
        const plane::Points points = uniform_points(lattice, 4000, 5);
        for (const plane::Vec2 p : points.colwise()) {
            largest = std::max(largest, flow.velocity(p).norm());
        }
        EXPECT_LE(largest, 1 + 1e-12) << name;
        EXPECT_GT(largest, 0.95) << name;
    }
}

TEST(DecayingFlow, TheStreamFunctionGivesTheFluxThroughASegment) {
    for (const auto& [name, lattice] : lattices()) {
        const DecayingFlow flow(lattice);
        const plane::Points points = uniform_points(lattice, 20, 6);
        const plane::Vec2 step = 1e-2 / std::sqrt(flow.rate()) * plane::Vec2(0.6, 0.8);
        for (const plane::Vec2 p : points.colwise()) {
            // Simpson's rule for the velocity along the normal to the right of the segment.
            const plane::Vec2 mean =
                (flow.velocity(p) + 4 * flow.velocity(p + step / 2) + flow.velocity(p + step)) / 6;
            const double flux = mean.x() * step.y() - mean.y() * step.x();
            EXPECT_NEAR(flow.stream(p + step) - flow.stream(p), flux, 1e-9 * step.norm()) << name;
            EXPECT_LE(std::abs(flow.stream(p)), flow.largest_stream()) << name;
        }
    }
}

TEST(DecayingFlow, TheMeanSquareSpeedIsTheMeanOverAGrid) {
    for (const auto& [name, lattice] : lattices()) {
        const DecayingFlow flow(lattice);
        const int n = 40;
        double sum = 0;
        for (int k = 0; k < n * n; ++k) {
            sum += flow.velocity(lattice.to_position(plane::Vec2(k % n, k / n) / n)).squaredNorm();
        }
        EXPECT_NEAR(sum / (n * n), flow.mean_square_speed(), 1e-9) << name;
    }
}

TEST(DecayingFlow, OnTheUnitSquareItIsTheTaylorGreenFlow) {
    const DecayingFlow flow(plane::Lattice::rectangle(1, 1));
    const double k = 2 * std::numbers::pi;
    EXPECT_DOUBLE_EQ(flow.rate(), 2 * k * k);
    EXPECT_DOUBLE_EQ(flow.turn_time(), 0.25);
    const plane::Vec2 u = flow.velocity(plane::Vec2(0.1, 0.3));
    EXPECT_NEAR(std::abs(u.x()), std::abs(std::cos(k * 0.1) * std::sin(k * 0.3)), 1e-15);
    EXPECT_NEAR(std::abs(u.y()), std::abs(std::sin(k * 0.1) * std::cos(k * 0.3)), 1e-15);
}

}  // namespace
}  // namespace pcvt
