#include "mesher/torus/coincident_sites.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

namespace pcvt {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

Eigen::Matrix2d skewed() {
    Eigen::Matrix2d periods;
    periods << 1, 0.4, 0, 0.9;
    return periods;
}

template <int dimension>
Eigen::Matrix<double, dimension, Eigen::Dynamic> random_coordinates(int n, unsigned seed) {
    std::mt19937 generator(seed);
    std::uniform_real_distribution<double> uniform(0, 1);
    Eigen::Matrix<double, dimension, Eigen::Dynamic> points(dimension, n);
    for (double& u : points.reshaped()) u = uniform(generator);
    return points;
}

/// Compares each site with all earlier ones.
template <class Coordinates, class Periods>
std::vector<CoincidentSite> by_brute_force(const Coordinates& u, const Periods& periods,
                                           double distance) {
    std::vector<CoincidentSite> found;
    std::vector<SiteId> kept;
    for (SiteId s = 0; s < u.cols(); ++s) {
        const auto is_near = [&](SiteId t) {
            const auto difference = (u.col(s) - u.col(t)).eval();
            const auto nearest = (difference - difference.array().round().matrix()).eval();
            return (periods * nearest).norm() < distance;
        };
        const auto first = std::find_if(kept.begin(), kept.end(), is_near);
        if (first == kept.end()) {
            kept.push_back(s);
        } else {
            found.push_back({s, *first});
        }
    }
    return found;
}

TEST(CoincidentSites, FindsThemAcrossTheSeam) {
    Eigen::Matrix2Xd u(2, 4);
    u << 0, 0.5, 1 - 1e-12, 0.5 + 2e-9, 0.25, 0.5, 0.25, 0.5;
    EXPECT_THAT(coincident_sites(u, skewed(), 1e-9), ElementsAre(CoincidentSite{2, 0}));
    EXPECT_THAT(coincident_sites(u, skewed(), 1e-8),
                ElementsAre(CoincidentSite{2, 0}, CoincidentSite{3, 1}));
}

TEST(CoincidentSites, EqualThoseOfBruteForceInThePlane) {
    for (unsigned seed = 0; seed < 20; ++seed) {
        const Eigen::Matrix2Xd u = random_coordinates<2>(200, seed);
        for (const double distance : {1e-4, 1e-3, 1e-2, 0.03}) {
            EXPECT_EQ(coincident_sites(u, skewed(), distance),
                      by_brute_force(u, skewed(), distance));
        }
    }
}

TEST(CoincidentSites, EqualThoseOfBruteForceInSpace) {
    Eigen::Matrix3d periods;
    periods << 1, 0.4, -0.3, 0, 0.9, 0.2, 0, 0, 1.1;
    for (unsigned seed = 0; seed < 20; ++seed) {
        const Eigen::Matrix3Xd u = random_coordinates<3>(200, seed);
        for (const double distance : {1e-3, 1e-2, 0.05}) {
            EXPECT_EQ(coincident_sites(u, periods, distance), by_brute_force(u, periods, distance));
        }
    }
}

TEST(CoincidentSites, ManyAtOnePointTakeNoQuadraticTime) {
    Eigen::Matrix2Xd u = Eigen::Matrix2Xd::Constant(2, 200'000, 0.5);
    const auto found = coincident_sites(u, skewed(), 1e-9);
    ASSERT_EQ(found.size(), 199'999U);
    EXPECT_EQ(found.back(), (CoincidentSite{199'999, 0}));
}

TEST(CoincidentSites, DroppingThemLeavesNone) {
    Eigen::Matrix2Xd u = random_coordinates<2>(100, 1);
    u.rightCols(50) = u.leftCols(50).array() + 1e-12;
    const double h = 0.1;
    const auto dropped = sites_to_drop(u, skewed(), h);
    ASSERT_EQ(dropped.size(), 50U);
    const std::vector<SiteId> kept = kept_sites(100, dropped);
    EXPECT_EQ(kept.size(), 50U);
    EXPECT_EQ(kept.back(), 49);
    const Eigen::Matrix2Xd left = u(Eigen::all, kept);
    EXPECT_THAT(coincident_sites(left, skewed(), kCoincident * h), IsEmpty());
}

TEST(CoincidentSites, AreNamedByTheirLines) {
    const DroppedSites dropped = dropped_sites({{2, 0}, {3, 1}}, {4, 5, 8, 9});
    EXPECT_THAT(dropped.lines, ElementsAre(CoincidentSite{8, 4}, CoincidentSite{9, 5}));
    EXPECT_EQ(coincidence_list(dropped.lines, [](int k) { return "line " + std::to_string(k); }),
              "line 8 with line 4, line 9 with line 5");
    EXPECT_THAT(dropped_sites({{2, 0}}, {}).lines, IsEmpty());
}

TEST(CoincidentSites, OfThousandsTheFirstThousandAreNamed) {
    std::vector<CoincidentSite> pairs;
    for (int k = 1; k <= 1500; ++k) pairs.push_back({k, 0});
    const std::string text = DuplicateSites(pairs).what();
    EXPECT_THAT(text, ::testing::StartsWith("1500 sites coincide with earlier ones"));
    EXPECT_THAT(text, ::testing::HasSubstr("site 1000 with site 0 and 500 more; remove them"));
}

}  // namespace
}  // namespace pcvt
