#include "mesher/space/geometry/insertion_order.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace pcvt::space {
namespace {

Eigen::Matrix3Xd random_coordinates(int n) {
    std::srand(1);
    return (Eigen::Matrix3Xd::Random(3, n).array() + 1) * 0.49999;
}

TEST(SpreadSample, HasTheSiteNearestToTheMiddleOfEachBox) {
    const Eigen::Matrix3Xd u = random_coordinates(300);
    const Eigen::Array3d size(2, 3, 4);
    std::vector<SiteId> expected;
    for (int b = 0; b < 24; ++b) {
        const Eigen::Array3d box(b / 12, b / 4 % 3, b % 4);
        SiteId best = -1;
        double least = 1;
        for (SiteId s = 0; s < 300; ++s) {
            const Eigen::Array3d at = u.col(s).array() * size - box - 0.5;
            if (at.abs().maxCoeff() > 0.5 || at.matrix().squaredNorm() >= least) continue;
            least = at.matrix().squaredNorm();
            best = s;
        }
        if (best >= 0) expected.push_back(best);
    }
    EXPECT_EQ(spread_sample(u, {2, 3, 4}), expected);
}

TEST(SpreadSample, SkipsEmptyBoxes) {
    Eigen::Matrix3Xd u(3, 2);
    u << 0.1, 0.9, 0.1, 0.9, 0.1, 0.9;
    EXPECT_EQ(spread_sample(u, {2, 2, 2}), (std::vector<SiteId>{0, 1}));
}

TEST(InsertionOrder, HasEverySiteOnceAndTheSampleFirst) {
    const Eigen::Matrix3Xd u = random_coordinates(1000);
    const std::vector<SiteId> first{17, 3, 999};
    std::vector<SiteId> order = insertion_order(u, first);
    ASSERT_EQ(order.size(), 1000u);
    EXPECT_TRUE(std::equal(first.begin(), first.end(), order.begin()));
    std::sort(order.begin(), order.end());
    std::vector<SiteId> all(1000);
    std::iota(all.begin(), all.end(), 0);
    EXPECT_EQ(order, all);
}

TEST(InsertionOrder, AllSitesMayBeFirst) {
    EXPECT_EQ(insertion_order(random_coordinates(2), {1, 0}), (std::vector<SiteId>{1, 0}));
}

/// Successive sites are a few times the mean distance of the sites apart, not half a period.
TEST(InsertionOrder, KeepsSuccessiveSitesNear) {
    const int n = 8000;
    const Eigen::Matrix3Xd u = random_coordinates(n);
    const std::vector<SiteId> order = insertion_order(u, {});
    double sum = 0;
    for (int k = n / 2; k + 1 < n; ++k) sum += (u.col(order[k]) - u.col(order[k + 1])).norm();
    EXPECT_LT(sum / (n / 2.0), 2.0 / 20);
}

/// The first eighth is spread over the whole cube, as is the first eighth of that.
TEST(InsertionOrder, BeginsWithARandomSubset) {
    const int n = 8000;
    const Eigen::Matrix3Xd u = random_coordinates(n);
    const std::vector<SiteId> order = insertion_order(u, {});
    for (const int n_first : {n / 10, n / 100}) {
        Eigen::Vector3d sum = Eigen::Vector3d::Zero();
        for (int k = 0; k < n_first; ++k) sum += u.col(order[k]);
        EXPECT_LT((sum / n_first - Eigen::Vector3d::Constant(0.5)).norm(), 2 / std::sqrt(n_first));
    }
}

}  // namespace
}  // namespace pcvt::space
