#include "mesher/plane/search/search_starts.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <set>

#include "tests/support/example_lattices.hpp"
#include "tests/support/lattices.hpp"

namespace pcvt::plane {
namespace {

using ::testing::HasSubstr;
using testing::kOblique;

std::vector<SearchState> only_the_lattice(const Lattice& period, int n) {
    const LatticePattern pattern = best_lattice(period, n);
    return {{pattern_points(pattern), {n}, pattern.energy}};
}

/// Returns the distance modulo the lattice from p to the nearest of the points.
double distance_to(const Points& points, const Vec2& p, const Lattice& period) {
    const Lattice reduced = reduce(period).reduced;
    double nearest = std::numeric_limits<double>::infinity();
    for (Eigen::Index s = 0; s < points.cols(); ++s) {
        Vec2 u = reduced.to_lattice(p - points.col(s));
        u -= u.array().round().matrix();
        nearest = std::min(nearest, reduced.to_position(u).norm());
    }
    return nearest;
}

TEST(StartMaker, GivesTheRequestedNumberOfSites) {
    for (const auto& [name, period] : testing::lattices()) {
        for (const int n : {1, 2, 3, 12, 60}) {
            StartMaker maker(period, n);
            StartMaker::Random random(7);
            for (int k = 0; k < 40; ++k) {
                const SearchState start = maker.make(random, only_the_lattice(period, n));
                ASSERT_EQ(start.points.cols(), n) << name;
                EXPECT_TRUE(start.points.allFinite()) << name << n;
            }
        }
    }
}

TEST(StartMaker, GivesTheSameForTheSameSeed) {
    StartMaker one(kOblique, 30);
    StartMaker other(kOblique, 30);
    StartMaker::Random random(3);
    StartMaker::Random same(3);
    for (int k = 0; k < 30; ++k) {
        EXPECT_EQ(one.make(random, only_the_lattice(kOblique, 30)).points,
                  other.make(same, only_the_lattice(kOblique, 30)).points);
    }
}

TEST(StartMaker, GivesEveryKindOfStart) {
    StartMaker maker(kOblique, 40);
    StartMaker::Random random(1);
    std::set<std::string> kinds;
    for (int k = 0; k < 300; ++k) {
        const StartOrigin origin = maker.make(random, only_the_lattice(kOblique, 40)).origin;
        const int change = origin.lattice_sites - 40;
        kinds.insert(origin.restarts > 0         ? "restart"
                     : origin.lattice_sites == 0 ? "random"
                                                 : std::string(change > 0 ? "fewer" : "more") +
                                                       (origin.in_row ? " in a row" : ""));
    }
    EXPECT_EQ(kinds.size(), 6);
}

TEST(StartMaker, LeavesTheSitesOfANeighbouringLatticeNearTheirPlaces) {
    constexpr int kN = 50;
    const double h = std::sqrt(kOblique.area() / kN);
    StartMaker maker(kOblique, kN);
    StartMaker::Random random(5);
    for (int k = 0; k < 60; ++k) {
        const SearchState start = maker.make(random, only_the_lattice(kOblique, kN));
        if (start.origin.restarts > 0 || start.origin.lattice_sites == 0) continue;
        const int m = start.origin.lattice_sites;
        const Points places =
            pattern_points(best_lattices(kOblique, m, start.origin.rank + 1).back());
        for (int s = 0; s < std::min(kN, m); ++s) {
            EXPECT_LE(distance_to(places, start.points.col(s), kOblique), 0.15001 * h);
        }
    }
}

TEST(StartMaker, ShakesTheMinimaForARestart) {
    StartMaker maker(kOblique, 20);
    StartMaker::Random random(2);
    const std::vector<SearchState> minima = only_the_lattice(kOblique, 20);
    const double h = std::sqrt(kOblique.area() / 20);
    int n_restarts = 0;
    for (int k = 0; k < 50; ++k) {
        const SearchState start = maker.make(random, minima);
        if (start.origin.restarts == 0) continue;
        ++n_restarts;
        const double largest = (start.points - minima[0].points).colwise().norm().maxCoeff();
        EXPECT_GT(largest, 0.05 * h);
        EXPECT_LE(largest, 0.6 * h);
    }
    EXPECT_GT(n_restarts, 5);
}

TEST(StartWords, DescribeTheOriginOfAStart) {
    EXPECT_EQ(start_words({}, 18), "random sites");
    EXPECT_EQ(start_words({18}, 18), "lattice of 18");
    EXPECT_EQ(
        start_words({20, 2, true, 3}, 18),
        "lattice of 20 (number 3 by energy), 2 sites removed in a row, then 3 noisy restarts");
    EXPECT_EQ(start_words({17, 0, false, 1}, 18),
              "lattice of 17, 1 site added, then 1 noisy restart");
}

}  // namespace
}  // namespace pcvt::plane
