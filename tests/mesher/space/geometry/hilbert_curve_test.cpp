#include "mesher/space/geometry/hilbert_curve.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <vector>

namespace pcvt::space {
namespace {

constexpr int kSide = 8;
constexpr int kBoxes = kSide * kSide * kSide;

/// The 8 x 8 x 8 boxes that the upper three bits distinguish, in the order of the curve.
std::vector<std::array<int, 3>> coarse_curve() {
    std::vector<std::array<int, 3>> curve(kBoxes, {-1, -1, -1});
    for (int b = 0; b < kBoxes; ++b) {
        const std::array<int, 3> box{b / (kSide * kSide), b / kSide % kSide, b % kSide};
        std::array<std::uint32_t, 3> fine;
        for (int k = 0; k < 3; ++k) fine[k] = std::uint32_t(box[k]) << (kHilbertBits - 3);
        curve.at(hilbert_index(fine) >> (3 * (kHilbertBits - 3))) = box;
    }
    return curve;
}

TEST(HilbertCurve, VisitsEveryBoxOnce) {
    for (const auto& box : coarse_curve()) EXPECT_NE(box[0], -1);
}

TEST(HilbertCurve, SuccessiveBoxesShareAFace) {
    const auto curve = coarse_curve();
    for (int b = 0; b < kBoxes; ++b) {
        const auto& here = curve[b];
        const auto& next = curve[(b + 1) % kBoxes];
        int distance = 0;
        for (int k = 0; k < 3; ++k) {
            const int apart = std::abs(here[k] - next[k]);
            distance += std::min(apart, kSide - apart);
        }
        // The last box and the first one share a face of the periodic cube.
        EXPECT_EQ(distance, 1) << b;
    }
}

TEST(HilbertCurve, UsesAllBits) {
    const std::uint32_t last = (1 << kHilbertBits) - 1;
    EXPECT_EQ(hilbert_index({0, 0, 0}), 0u);
    EXPECT_NE(hilbert_index({last, last, last}), hilbert_index({last, last, last - 1}));
    EXPECT_LT(hilbert_index({last, last, last}), std::uint64_t{1} << (3 * kHilbertBits));
}

/// The boxes in the order of the curve, given in another one.
TEST(HilbertOrder, SortsPointsAlongTheCurve) {
    const auto curve = coarse_curve();
    Eigen::Matrix3Xd points(3, kBoxes);
    std::vector<SiteId> expected(kBoxes);
    for (int b = 0; b < kBoxes; ++b) {
        const SiteId site = 101 * b % kBoxes;
        for (int k = 0; k < 3; ++k) points(k, site) = (curve[b][k] + 0.5) / kSide;
        expected[b] = site;
    }
    EXPECT_EQ(hilbert_order(points), expected);
}

TEST(HilbertOrder, KeepsTheOrderOfNumbersInOneBox) {
    EXPECT_EQ(hilbert_order(Eigen::Matrix3Xd::Constant(3, 4, 0.3)),
              (std::vector<SiteId>{0, 1, 2, 3}));
}

}  // namespace
}  // namespace pcvt::space
