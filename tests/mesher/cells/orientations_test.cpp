#include "mesher/cells/orientations.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

namespace pcvt {
namespace {

constexpr double kDegree = M_PI / 180;

TEST(Orientations, Law1RowsAreOrthonormalAndRightHanded) {
    for (const BungeAngles& angles : random_orientations(1000, 3)) {
        const Eigen::Matrix3d g = bunge_matrix(angles);
        EXPECT_LT((g * g.transpose() - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff(), 1e-15);
        EXPECT_NEAR(g.determinant(), 1, 2e-15);
    }
}

TEST(Orientations, Law2TheMatrixIsTheProductOfThreeTurns) {
    using Turn = Eigen::AngleAxisd;
    for (const BungeAngles& angles : random_orientations(1000, 4)) {
        // Coordinates turn against the axes.
        const Eigen::Matrix3d wanted = (Turn(-angles.phi2 * kDegree, Eigen::Vector3d::UnitZ()) *
                                        Turn(-angles.Phi * kDegree, Eigen::Vector3d::UnitX()) *
                                        Turn(-angles.phi1 * kDegree, Eigen::Vector3d::UnitZ()))
                                           .toRotationMatrix();
        EXPECT_LT((bunge_matrix(angles) - wanted).cwiseAbs().maxCoeff(), 2e-15);
    }
    const Eigen::Matrix3d turned = bunge_matrix({45, 0, 0});
    EXPECT_NEAR(turned(0, 1), std::sqrt(0.5), 1e-16);
    EXPECT_NEAR(turned(1, 0), -std::sqrt(0.5), 1e-16);
}

TEST(Orientations, RandomOnesHaveNoTexture) {
    // The mean of the components g_ij is 0, that of their squares 1/3 and that of g_ij g_kl 0.
    const int n = 20'000;
    Eigen::Matrix3d mean = Eigen::Matrix3d::Zero();
    Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
    double cosine_fourth = 0;
    for (const BungeAngles& angles : random_orientations(n, 5)) {
        EXPECT_TRUE(angles.phi1 >= 0 && angles.phi1 < 360);
        EXPECT_TRUE(angles.Phi > 0 && angles.Phi < 180);
        EXPECT_TRUE(angles.phi2 >= 0 && angles.phi2 < 360);
        const Eigen::Matrix3d g = bunge_matrix(angles);
        mean += g / n;
        squares += g.cwiseAbs2() / n;
        cosine_fourth += std::pow(g(2, 2), 4) / n;
    }
    // Four standard deviations.
    const double spread = 4 / std::sqrt(n);
    EXPECT_LT(mean.cwiseAbs().maxCoeff(), spread * std::sqrt(1.0 / 3));
    EXPECT_LT((squares.array() - 1.0 / 3).abs().maxCoeff(), spread * std::sqrt(4.0 / 45));
    EXPECT_NEAR(cosine_fourth, 0.2, spread * std::sqrt(1.0 / 9 - 0.04));
}

TEST(Orientations, AreTheSameBitsOnEveryMachine) {
    const std::vector<BungeAngles> drawn = random_orientations(2, 0);
    EXPECT_EQ(drawn, random_orientations(2, 0));
    EXPECT_NE(drawn, random_orientations(2, 1));
    EXPECT_EQ(drawn[0], random_orientations(1, 0)[0]);
    // As drawn on an AMD EPYC.
    EXPECT_EQ(drawn[0].phi1, 0x1.33c9261e22f8dp+8);
    EXPECT_EQ(drawn[0].Phi, 0x1.ebc138d8ac1b9p+6);
    EXPECT_EQ(drawn[1].Phi, 0x1.454589503fd6p+7);
}

TEST(Orientations, EntriesAreDrawnByTheirWeightsRoundedUpOrDown) {
    std::vector<double> weights;
    for (int k = 0; k < 50; ++k) weights.push_back(k % 7 == 3 ? 0 : 1 + k % 5 * 0.37);
    const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
    std::vector<double> mean(weights.size(), 0);
    const int n_seeds = 500;
    for (const int n : {1, 7, 50, 333}) {
        std::fill(mean.begin(), mean.end(), 0);
        for (int seed = 0; seed < n_seeds; ++seed) {
            const std::vector<int> drawn = draw_entries(weights, n, seed);
            ASSERT_EQ(std::ssize(drawn), n);
            for (std::size_t k = 0; k < weights.size(); ++k) {
                const auto times = double(std::count(drawn.begin(), drawn.end(), int(k)));
                EXPECT_LT(std::abs(times - n * weights[k] / sum), 1);
                mean[k] += times / n_seeds;
            }
        }
        for (std::size_t k = 0; k < weights.size(); ++k) {
            EXPECT_NEAR(mean[k], n * weights[k] / sum, 4 * 0.5 / std::sqrt(n_seeds)) << n;
        }
    }
}

TEST(Orientations, LongListsOfEqualWeightsGiveDifferentEntriesInRandomOrder) {
    const std::vector<double> alike(1000, 0.1);
    std::vector<int> drawn = draw_entries(alike, 600, 3);
    EXPECT_EQ(drawn, draw_entries(alike, 600, 3));
    EXPECT_NE(drawn, draw_entries(alike, 600, 4));
    // The first and the last half have the same mean, to four standard deviations.
    const double first = std::accumulate(drawn.begin(), drawn.begin() + 300, 0.0) / 300;
    const double last = std::accumulate(drawn.begin() + 300, drawn.end(), 0.0) / 300;
    EXPECT_NEAR(first, last, 4 * 1000 / std::sqrt(12.0) * std::sqrt(2.0 / 300));
    std::sort(drawn.begin(), drawn.end());
    EXPECT_EQ(std::unique(drawn.begin(), drawn.end()), drawn.end());
    EXPECT_EQ(draw_entries(std::vector<double>{0, 2, 0}, 3, 1), (std::vector<int>{1, 1, 1}));
}

}  // namespace
}  // namespace pcvt
