#include "mesher/optimize/packed_vectors.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace pcvt {
namespace {

using Eigen::VectorXf;

constexpr Eigen::Index kBlock = PackedVectors::kBlock;

/// Normally distributed numbers times a factor that differs from block to block.
VectorXf random_vector(Eigen::Index n, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    std::normal_distribution<float> normal;
    VectorXf x(n);
    for (Eigen::Index i = 0; i < n; ++i) {
        x[i] = std::ldexp(normal(random), -8 * static_cast<int>(i / kBlock));
    }
    return x;
}

/// Two vectors of several blocks; the last block is not full.
struct TwoVectors {
    static constexpr Eigen::Index kNumbers = 2 * kBlock + 37;
    static constexpr Eigen::Index kBlocks = 3;

    VectorXf given[2] = {random_vector(kNumbers, 1), random_vector(kNumbers, 2)};
    VectorXf rounded[2] = {given[0], given[1]};
    PackedVectors packed = PackedVectors(2, kNumbers);

    TwoVectors() {
        for (Eigen::Index b = 0; b < kBlocks; ++b) {
            for (const int v : {0, 1}) packed.pack(v, b, rounded[v].data() + b * kBlock);
        }
    }
    static VectorXf block_of(const VectorXf& x, Eigen::Index b) {
        return x.segment(b * kBlock, std::min(kBlock, kNumbers - b * kBlock));
    }
};

TEST(PackedVectors, RoundToA65534thOfTheLargestOfTheBlock) {
    const TwoVectors two;
    for (Eigen::Index b = 0; b < TwoVectors::kBlocks; ++b) {
        for (const int v : {0, 1}) {
            const VectorXf given = TwoVectors::block_of(two.given[v], b);
            const VectorXf rounded = TwoVectors::block_of(two.rounded[v], b);
            const float largest = given.cwiseAbs().maxCoeff();
            EXPECT_LE((given - rounded).cwiseAbs().maxCoeff(), largest / 65534 + 1e-7F * largest);
            EXPECT_GT((given - rounded).cwiseAbs().maxCoeff(), largest / 80000);
        }
    }
}

TEST(PackedVectors, UnpackTheRoundedNumbers) {
    const TwoVectors two;
    for (Eigen::Index b = 0; b < TwoVectors::kBlocks; ++b) {
        for (const int v : {0, 1}) {
            const VectorXf stored = TwoVectors::block_of(two.rounded[v], b);
            VectorXf unpacked = VectorXf::Zero(stored.size());
            two.packed.unpack(v, b, unpacked.data());
            EXPECT_EQ(unpacked, stored);
        }
    }
}

TEST(PackedVectors, MultiplyAndAddTheRoundedNumbers) {
    const TwoVectors two;
    for (Eigen::Index b = 0; b < TwoVectors::kBlocks; ++b) {
        const VectorXf x = random_vector(TwoVectors::block_of(two.given[0], b).size(), 3);
        for (const int v : {0, 1}) {
            const VectorXf stored = TwoVectors::block_of(two.rounded[v], b);
            const double product = x.cast<double>().dot(stored.cast<double>());
            EXPECT_NEAR(two.packed.dot(v, b, x.data()), product, 1e-6 * x.norm() * stored.norm());
            VectorXf sum = x;
            two.packed.add_multiple(v, b, -3, sum.data());
            EXPECT_LE((sum - (x - 3 * stored)).cwiseAbs().maxCoeff(), 1e-5);
        }
    }
}

TEST(PackedVectors, RoundingTwiceChangesNothing) {
    TwoVectors two;
    VectorXf again = two.rounded[0];
    for (Eigen::Index b = 0; b < TwoVectors::kBlocks; ++b) {
        two.packed.pack(1, b, again.data() + b * kBlock);
    }
    EXPECT_LE((again - two.rounded[0]).cwiseAbs().maxCoeff(), 1e-6);
}

TEST(PackedVectors, StoreZeroAndNegligibleNumbersAsZero) {
    PackedVectors packed(1, 4);
    for (const float size : {0.0F, 1e-38F, std::numeric_limits<float>::denorm_min()}) {
        VectorXf x = VectorXf::Constant(4, size);
        packed.pack(0, 0, x.data());
        EXPECT_EQ(x, VectorXf::Zero(4));
        EXPECT_EQ(packed.dot(0, 0, VectorXf::Ones(4).eval().data()), 0);
    }
}

TEST(PackedVectors, TurnABlockWithANumberThatIsNotFiniteIntoNan) {
    for (const float bad : {std::numeric_limits<float>::quiet_NaN(), HUGE_VALF, -HUGE_VALF}) {
        for (const Eigen::Index at : {0, 40}) {
            PackedVectors packed(1, 41);
            VectorXf x = random_vector(41, 4);
            x[at] = bad;
            packed.pack(0, 0, x.data());
            EXPECT_TRUE(x.array().isNaN().all());
            EXPECT_TRUE(std::isnan(packed.dot(0, 0, VectorXf::Ones(41).eval().data())));
        }
    }
}

}  // namespace
}  // namespace pcvt
