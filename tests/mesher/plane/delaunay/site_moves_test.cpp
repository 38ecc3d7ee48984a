#include "mesher/plane/delaunay/site_moves.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace pcvt::plane {
namespace {

constexpr ReducedFrame kOblique{1.5, 0.4, 1.2};
constexpr SiteId kSites = 100;

/// Random multiples of 2^-51 in [-1, 2).
Points random_coordinates(std::mt19937_64& random) {
    std::uniform_real_distribution<double> uniform(-1, 2 - 1e-9);
    Points coordinates(2, kSites);
    for (double& u : coordinates.reshaped()) u = std::nearbyint(uniform(random) * 0x1p51) * 0x1p-51;
    return coordinates;
}

Eigen::VectorXf random_direction(std::mt19937_64& random, float size) {
    std::normal_distribution<float> normal;
    Eigen::VectorXf direction(2 * kSites);
    for (float& x : direction) x = size * normal(random);
    return direction;
}

TEST(SiteMoves, AreUndoneExactly) {
    std::mt19937_64 random(1);
    for (const float size : {1e-20f, 1e-15f, 1e-7f, 0.1f, 1.0f, 1e5f, 1e30f}) {
        for (const double t : {1.0, 0.3, -2.7}) {
            const Points start = random_coordinates(random);
            const Eigen::VectorXf direction = random_direction(random, size);
            const SiteMoves moves(kOblique, direction, t);
            Points coordinates = start;
            EXPECT_TRUE(moves.apply(0, kSites, coordinates).finite);
            for (SiteId s = 0; s < kSites; ++s) {
                EXPECT_EQ(Vec2(start.col(s) + moves.of(s)), coordinates.col(s)) << size;
            }
            EXPECT_EQ((coordinates * 0x1p51).array().round().matrix(), coordinates * 0x1p51);
            moves.back().apply(0, kSites, coordinates);
            EXPECT_EQ(start, coordinates) << size << " " << t;
        }
    }
}

TEST(SiteMoves, OmitWholePeriods) {
    Eigen::VectorXf direction(4);
    const Vec2 periods = kOblique.to_position({3, -2});
    direction << periods.cast<float>(),
        (periods + kOblique.to_position({0.25, -0.375})).cast<float>();
    const SiteMoves moves(kOblique, direction, 1);
    EXPECT_LT(moves.of(0).norm(), 1e-6);
    EXPECT_LT((moves.of(1) - Vec2(0.25, -0.375)).norm(), 1e-6);
}

TEST(SiteMoves, OfARangeOfSitesLeaveTheOthersUnchanged) {
    std::mt19937_64 random(2);
    const Points start = random_coordinates(random);
    const Eigen::VectorXf direction = random_direction(random, 0.1f);
    Points coordinates = start;
    const SiteMoves moves(kOblique, direction, 1);
    moves.apply(30, 70, coordinates);
    EXPECT_EQ(coordinates.leftCols(30), start.leftCols(30));
    EXPECT_EQ(coordinates.rightCols(30), start.rightCols(30));
    for (SiteId s = 30; s < 70; ++s) {
        EXPECT_EQ(Vec2(start.col(s) + moves.of(s)), coordinates.col(s));
    }
}

TEST(SiteMoves, ReportAndOmitMovesThatAreNotFinite) {
    std::mt19937_64 random(3);
    const Points start = random_coordinates(random);
    for (const float wrong :
         {std::numeric_limits<float>::infinity(), -std::numeric_limits<float>::infinity(),
          std::numeric_limits<float>::quiet_NaN()}) {
        for (const int at : {0, 101, 199}) {
            Eigen::VectorXf direction = random_direction(random, 0.1f);
            direction[at] = wrong;
            const SiteMoves moves(kOblique, direction, 1);
            Points coordinates = start;
            EXPECT_FALSE(moves.apply(0, kSites, coordinates).finite);
            EXPECT_TRUE(coordinates.allFinite());
            moves.back().apply(0, kSites, coordinates);
            EXPECT_EQ(start, coordinates);
        }
    }
}

TEST(SiteMoves, ReportCoordinatesThatLeaveTheirRange) {
    const Points start = Points::Constant(2, kSites, 0.5);
    for (const SiteId site : {0, 57, 99}) {
        for (const Vec2& edge : {Vec2(-0.99, 0), Vec2(0, -0.99), Vec2(1.99, 0), Vec2(0, 1.99)}) {
            for (const double beyond : {0.005, 0.02}) {
                Points coordinates = start;
                coordinates.col(site) = edge;
                const Vec2 outwards = beyond * edge.cwiseSign();
                Eigen::VectorXf direction = Eigen::VectorXf::Zero(2 * kSites);
                direction.segment<2>(2 * site) = kOblique.to_position(outwards).cast<float>();
                const auto outcome =
                    SiteMoves(kOblique, direction, 1).apply(0, kSites, coordinates);
                EXPECT_EQ(outcome.in_range, beyond < 0.01) << edge.transpose();
            }
        }
    }
}

}  // namespace
}  // namespace pcvt::plane
