#include "mesher/plane/delaunay/spatial_sort.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "mesher/plane/delaunay/moving_delaunay.hpp"
#include "mesher/plane/geometry/sites.hpp"
#include "tests/support/lattices.hpp"
#include "tests/support/site_columns.hpp"
#include "tests/support/special_sites.hpp"

namespace pcvt::plane {
namespace {

using testing::columns_of;
using testing::lattices;

void expect_columns(const Sites& sites) {
    const SpatialSort columns = columns_of(sites);
    const Points& u = sites.coordinates();
    const int across = columns.across;
    std::vector<SiteId> ids = columns.order;
    std::sort(ids.begin(), ids.end());
    for (SiteId s = 0; s < sites.n_sites(); ++s) ASSERT_EQ(ids[s], s);
    ASSERT_EQ(columns.begin.front(), 0);
    ASSERT_EQ(columns.begin.back(), sites.n_sites());
    const int fewest = sites.n_sites() / columns.n_columns();
    double reached = -1;
    for (int k = 0; k < columns.n_columns(); ++k) {
        const int count = columns.begin[k + 1] - columns.begin[k];
        ASSERT_TRUE(count == fewest || count == fewest + 1);
        double highest = reached;
        for (int m = columns.begin[k]; m < columns.begin[k + 1]; ++m) {
            const SiteId s = columns.order[m];
            ASSERT_GE(u(across, s), reached);
            highest = std::max(highest, u(across, s));
            if (m == columns.begin[k]) continue;
            const SiteId t = columns.order[m - 1];
            ASSERT_LE(std::pair(u(1 - across, t), t), std::pair(u(1 - across, s), s));
        }
        reached = highest;
    }
}

TEST(SpatialSort, ColumnsAreSortedAndNearlyEqual) {
    for (const auto& [name, lattice] : lattices()) {
        for (const int n : {1, 2, 3, 10, 97, 1000}) {
            SCOPED_TRACE(name + " n = " + std::to_string(n));
            expect_columns(Sites(lattice, uniform_points(lattice, n, 4)));
        }
    }
    for (const auto& [name, sites] : testing::special_sites()) {
        SCOPED_TRACE(name);
        expect_columns(sites);
    }
}

// Many sites close to few points: large bins.
TEST(SpatialSort, ColumnsAreSortedWhereSitesAreClustered) {
    const Lattice unit = Lattice::rectangle(1, 1);
    for (const double spread : {1e-2, 1e-5, 1e-12}) {
        Points points = spread * uniform_points(unit, 500, 5);
        points.rightCols(250).array() += 0.3;
        expect_columns(Sites(unit, points));
    }
}

TEST(SpatialSort, ColumnsAreAsFarApartAsTheirSites) {
    for (const auto& [name, lattice] : lattices()) {
        const Sites sites(lattice, uniform_points(lattice, 10000, 6));
        const Lattice& reduced = sites.reduction().reduced;
        const SpatialSort columns = columns_of(sites);
        const double length = (columns.across == 0 ? reduced.b() : reduced.a()).norm();
        const double apart = reduced.area() / length / columns.n_columns();
        const double along = length / (10000.0 / columns.n_columns());
        EXPECT_NEAR(apart / along, 1, 0.2) << name;
    }
}

// Columns along the long period of 20 x 1 would have 447 sites.
TEST(SpatialSort, ColumnsAreShortInThinDomains) {
    const auto longest_column = [](const Lattice& lattice, int n) {
        const SpatialSort columns = columns_of(Sites(lattice, uniform_points(lattice, n, 8)));
        return n / columns.n_columns() + 1;
    };
    for (const auto& [name, lattice] : lattices()) {
        EXPECT_LE(longest_column(lattice, 10000), std::sqrt(2.0) * 110) << name;
    }
    EXPECT_LE(longest_column(Lattice::rectangle(20, 1), 10000), 25);
    EXPECT_LE(longest_column(Lattice::rectangle(1e-3, 1), 10000), 5);
}

// Up to a ratio of 2 columns go along the second vector of the reduced basis, and files keep their
// bytes.
TEST(SpatialSort, ColumnsOfNearlySquareDomainsGoAlongTheSecondVector) {
    const auto across = [](const Lattice& lattice) {
        return columns_of(Sites(lattice, uniform_points(lattice, 10, 9))).across;
    };
    EXPECT_EQ(across(Lattice::rectangle(1, 1)), 0);
    EXPECT_EQ(across(Lattice::rectangle(1, 2)), 0);
    EXPECT_EQ(across(Lattice::rectangle(2, 1)), 0);
    EXPECT_EQ(across(Lattice::rectangle(2.01, 1)), 1);
    EXPECT_EQ(across(Lattice::rectangle(1, 2.01)), 1);
    EXPECT_EQ(across(Lattice({1, 0}, {7, 1})), 0);
}

/// Between sites of successive numbers, in units of h.
double mean_distance(const Sites& sites) {
    double sum = 0;
    for (SiteId s = 1; s < sites.n_sites(); ++s) {
        sum += (sites.position(s) - sites.position(s - 1)).norm();
    }
    return sum / (sites.n_sites() - 1) / sites.spacing();
}

std::vector<std::pair<double, double>> sorted_coordinates(const Sites& sites) {
    std::vector<std::pair<double, double>> all;
    for (const auto& u : sites.coordinates().colwise()) all.emplace_back(u.x(), u.y());
    std::sort(all.begin(), all.end());
    return all;
}

TEST(Numbering, ByColumnsNeighboursHaveNumbersNearToEachOther) {
    for (const auto& [name, lattice] : lattices()) {
        const Sites given(lattice, uniform_points(lattice, 2000, 7));
        const Sites numbered = MovingDelaunay(given, Numbering::kByColumns).release().first;
        EXPECT_EQ(sorted_coordinates(numbered), sorted_coordinates(given)) << name;
        EXPECT_LT(mean_distance(numbered), 2.5) << name;
        EXPECT_GT(mean_distance(given), 5) << name;
    }
}

// Sites that were numbered by columns keep their numbers, also where coordinates are equal.
TEST(Numbering, ByColumnsTwiceIsByColumnsOnce) {
    const auto numbered = [](const Sites& sites) {
        return MovingDelaunay(sites, Numbering::kByColumns).release().first;
    };
    for (const auto& [name, lattice] : lattices()) {
        const Sites once = numbered(Sites(lattice, uniform_points(lattice, 500, 3)));
        EXPECT_EQ(numbered(once).coordinates(), once.coordinates()) << name;
        Points grid(2, 144);
        for (int k = 0; k < 144; ++k)
            grid.col(k) = lattice.to_position({k % 9 / 9.0, k / 9 / 16.0});
        const Sites square = numbered(Sites(lattice, grid));
        EXPECT_EQ(numbered(square).coordinates(), square.coordinates()) << name;
    }
}

}  // namespace
}  // namespace pcvt::plane
