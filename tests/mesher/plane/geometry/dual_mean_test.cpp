#include "mesher/plane/geometry/dual_mean.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

namespace pcvt::plane {
namespace {

/// Sites in convex position, counter-clockwise.
std::vector<DualSite> random_polygon(int n, std::mt19937_64& random) {
    std::uniform_real_distribution<double> uniform(0, 1);
    std::vector<DualSite> polygon;
    for (int k = 0; k < n; ++k) {
        const double angle = 2 * M_PI * (k + 0.6 * uniform(random)) / n;
        polygon.push_back({Vec2(std::cos(angle), 0.8 * std::sin(angle)), 0.01 * uniform(random)});
    }
    return polygon;
}

double power(const DualSite& site, const Vec2& p) {
    return (p - site.point).squaredNorm() - site.weight;
}

Vec2 power_centre(const DualSite& p, const DualSite& q, const DualSite& r) {
    Eigen::Matrix2d rows;
    rows << (q.point - p.point).transpose(), (r.point - p.point).transpose();
    const auto side = [&](const DualSite& s) {
        return (s.point.squaredNorm() - s.weight - p.point.squaredNorm() + p.weight) / 2;
    };
    return rows.inverse() * Vec2(side(q), side(r));
}

/// The mean over all triangles of sites in whose circles no other site lies.
Vec2 mean_by_brute_force(const std::vector<DualSite>& sites) {
    Vec2 sum(0, 0);
    int n = 0;
    for (std::size_t i = 0; i < sites.size(); ++i) {
        for (std::size_t j = i + 1; j < sites.size(); ++j) {
            for (std::size_t k = j + 1; k < sites.size(); ++k) {
                const Vec2 p = power_centre(sites[i], sites[j], sites[k]);
                bool is_empty = true;
                for (const DualSite& s : sites) {
                    is_empty = is_empty && power(s, p) > power(sites[i], p) - 1e-9;
                }
                if (!is_empty) continue;
                sum += p;
                ++n;
            }
        }
    }
    return sum / n;
}

TEST(DualMean, IsTheMeanOverTheTrianglesWithEmptyCircles) {
    std::mt19937_64 random(3);
    for (int round = 0; round < 400; ++round) {
        const std::vector<DualSite> polygon = random_polygon(3 + round % 7, random);
        const auto mean = dual_mean(polygon, 1e-16);
        ASSERT_TRUE(mean);
        EXPECT_NEAR((mean->point - mean_by_brute_force(polygon)).norm(), 0, 1e-9) << round;
    }
}

TEST(DualMean, SpreadIsTheDistanceOfTheFarthestVertex) {
    const std::vector<DualSite> polygon{{Vec2(0, 0)}, {Vec2(2, -1)}, {Vec2(4, 0)}, {Vec2(2, 1)}};
    // The triangles share the short diagonal; their circumcentres are (1.25, 0) and (2.75, 0).
    const auto mean = dual_mean(polygon, 1e-16);
    ASSERT_TRUE(mean);
    EXPECT_NEAR((mean->point - Vec2(2, 0)).norm(), 0, 1e-12);
    EXPECT_NEAR(mean->spread, 0.75, 1e-12);
}

TEST(DualMean, DoesNotDependOnTheFirstSiteAndMovesWithTheSites) {
    std::mt19937_64 random(4);
    for (int round = 0; round < 100; ++round) {
        std::vector<DualSite> polygon = random_polygon(3 + round % 7, random);
        const Vec2 mean = dual_mean(polygon, 1e-16)->point;
        std::rotate(polygon.begin(), polygon.begin() + 1, polygon.end());
        for (DualSite& site : polygon) site.point += Vec2(5, -2);
        EXPECT_NEAR((dual_mean(polygon, 1e-16)->point - mean - Vec2(5, -2)).norm(), 0, 1e-11);
    }
}

TEST(DualMean, ErrorBoundsTheEffectOfRoundedSites) {
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> step(-1e-9, 1e-9);
    for (int round = 0; round < 400; ++round) {
        std::vector<DualSite> polygon = random_polygon(3, random);
        // Two sites close together.
        polygon[1].point = polygon[0].point + 1e-3 * (polygon[1].point - polygon[0].point);
        const auto mean = dual_mean(polygon, 1e-9);
        for (DualSite& site : polygon) site.point += Vec2(step(random), step(random));
        EXPECT_LE((dual_mean(polygon, 1e-9)->point - mean->point).norm(), mean->error) << round;
    }
}

TEST(DualMean, NeedsSitesThatRunCounterClockwise) {
    const std::array<DualSite, 3> clockwise{DualSite{{0, 0}}, DualSite{{0, 1}}, DualSite{{1, 0}}};
    EXPECT_FALSE(dual_mean(clockwise, 1e-16));
}

}  // namespace
}  // namespace pcvt::plane
