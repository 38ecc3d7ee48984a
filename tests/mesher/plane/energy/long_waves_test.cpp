#include "mesher/plane/energy/long_waves.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/support/energy_at.hpp"
#include "tests/support/lattices.hpp"

namespace pcvt::plane {
namespace {

using Eigen::VectorXd;
using Eigen::VectorXf;

MovingDelaunay random_sites(const Lattice& lattice, int n, std::uint64_t seed) {
    return MovingDelaunay(Sites(lattice, uniform_points(lattice, n, seed)));
}

VectorXd apply(LongWaves& waves, const VectorXd& r) {
    VectorXf p;
    waves.apply(r, p);
    return p.cast<double>();
}

const Lattice kLattices[] = {Lattice::rectangle(1, 1), Lattice::rectangle(20, 1),
                             Lattice({1, 0}, {0.3, 0.9}), Lattice({3, 1}, {7, 2.5})};

TEST(LongWaves, AreSymmetricAndPositiveDefinite) {
    for (const Lattice& lattice : kLattices) {
        const MovingDelaunay delaunay = random_sites(lattice, 700, 1);
        Workers workers(1);
        LongWaves waves(delaunay, workers);
        const VectorXd r = VectorXd::Random(1400);
        const VectorXd s = VectorXd::Random(1400);
        const VectorXd inverse_r = apply(waves, r);
        const VectorXd inverse_s = apply(waves, s);
        EXPECT_NEAR(r.dot(inverse_s), s.dot(inverse_r), 1e-5 * r.norm() * inverse_s.norm());
        const double local = 1 / (2 * std::pow(delaunay.spacing(), 2));
        EXPECT_GE(r.dot(inverse_r), 0.999 * local * r.squaredNorm());
    }
}

TEST(LongWaves, AreLinear) {
    const MovingDelaunay delaunay = random_sites(kLattices[2], 700, 2);
    Workers workers(1);
    LongWaves waves(delaunay, workers);
    const VectorXd r = VectorXd::Random(1400);
    const VectorXd s = VectorXd::Random(1400);
    const VectorXd sum = apply(waves, r - 3 * s);
    EXPECT_LT((sum - (apply(waves, r) - 3 * apply(waves, s))).norm(), 1e-5 * sum.norm());
}

/// Regular hexagons of width 1.
MovingDelaunay hexagons(int width, int height) {
    Points points(2, 2 * width * height);
    for (int k = 0; k < width * height; ++k) {
        points.col(2 * k) << k % width, std::sqrt(3.0) * (k / width);
        points.col(2 * k + 1) << k % width + 0.5, std::sqrt(3.0) * (k / width + 0.5);
    }
    return MovingDelaunay{Sites(Lattice::rectangle(width, std::sqrt(3.0) * height), points)};
}

TEST(LongWaves, MoveAllSitesTogetherAsOneSiteAlone) {
    const MovingDelaunay delaunay = hexagons(15, 15);
    Workers workers(1);
    LongWaves waves(delaunay, workers);
    const double local = 1 / (2 * std::pow(delaunay.spacing(), 2));
    const VectorXd push = VectorXd::Ones(2 * delaunay.n_sites());
    // The grid and the hexagons interfere slightly.
    EXPECT_LT((apply(waves, push) - local * push).norm(), 0.2 * local * push.norm());
}

/// The change of the gradient per displacement along a direction.
VectorXd stiffness(MovingDelaunay& delaunay, const VectorXf& direction) {
    constexpr double kPart = 1e-4;
    Workers workers(1);
    EnergyPass pass(delaunay, workers);
    Energy energy;
    delaunay.step(direction, kPart, workers);
    EXPECT_TRUE(pass.evaluate(energy));
    const VectorXd change = energy.gradient / kPart;
    delaunay.step_back();
    EXPECT_TRUE(pass.evaluate(energy));
    return change - energy.gradient / kPart;
}

/// Waves along one period vector that move sites in both directions.
void expect_division(MovingDelaunay& delaunay, int coordinate) {
    Workers workers(1);
    LongWaves waves(delaunay, workers);
    for (const Vec2& along : {Vec2(1, 0), Vec2(0, 1)}) {
        VectorXf wave(2 * delaunay.n_sites());
        for (int s = 0; s < delaunay.n_sites(); ++s) {
            const double phase = 2 * std::numbers::pi * delaunay.coordinates()(coordinate, s);
            wave.segment<2>(2 * s) = (along * std::cos(phase)).cast<float>();
        }
        const VectorXd answer = apply(waves, stiffness(delaunay, wave));
        // The weight of the long waves is 0.4, and the single-site term adds a little.
        const double part = answer.dot(wave.cast<double>()) / double(wave.squaredNorm());
        EXPECT_NEAR(part, 0.4, 0.03);
        EXPECT_LT((answer - part * wave.cast<double>()).norm(), 0.03 * answer.norm());
    }
}

TEST(LongWaves, DivideTheLongestWavesByTheirStiffness) {
    MovingDelaunay delaunay = hexagons(40, 40);
    expect_division(delaunay, 0);
}

// Here columns of sites, and rows of the grid, go along the first period vector.
TEST(LongWaves, DivideTheLongestWavesOfThinDomainsByTheirStiffness) {
    MovingDelaunay delaunay = hexagons(120, 30);
    expect_division(delaunay, 0);
    expect_division(delaunay, 1);
}

TEST(LongWaves, ComputeTheSameBitsForAnyNumberOfWorkers) {
    const MovingDelaunay delaunay = random_sites(kLattices[0], 120000, 4);
    const VectorXd r = VectorXd::Random(240000);
    VectorXd first;
    for (const int n_threads : {1, 2, 3}) {
        Workers workers(n_threads);
        LongWaves waves(delaunay, workers);
        const VectorXd answer = apply(waves, r);
        if (n_threads == 1) first = answer;
        EXPECT_EQ(answer, first);
    }
}

}  // namespace
}  // namespace pcvt::plane
