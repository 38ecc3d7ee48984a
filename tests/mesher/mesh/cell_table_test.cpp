#include "mesher/mesh/cell_table.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "mesher/mesh/voronoi.hpp"
#include "tests/support/lattices.hpp"

namespace pcvt {
namespace {

CellTable table_of(const Lattice& lattice, int n) {
    return cell_table(cell_mesh(PeriodicDelaunay(Sites(lattice, uniform_points(lattice, n, 3)))));
}

TEST(CellTable, Law1TheAreasSumToThatOfTheDomain) {
    for (const auto& [name, lattice] : testing::lattices()) {
        const CellTable cells = table_of(lattice, 40);
        const double sum = std::accumulate(cells.area.begin(), cells.area.end(), 0.0);
        EXPECT_NEAR(sum / lattice.area(), 1, 1e-11) << name;
    }
}

TEST(CellTable, Law2TheSidesSumToSixACell) {
    for (const int n : {1, 2, 3, 40}) {
        const CellTable cells = table_of(Lattice({1, 0}, {0.37, 0.81}), n);
        ASSERT_EQ(cells.n_cells(), n);
        EXPECT_EQ(static_cast<int>(cells.neighbours.size()), 6 * n);
    }
}

TEST(CellTable, Law3NeighboursAreMutual) {
    const CellTable cells = table_of(Lattice({1, 0}, {0.37, 0.81}), 7);
    const auto count = [&](SiteId s, SiteId t) {
        const auto begin = cells.neighbours.begin();
        return std::count(begin + cells.neighbour_begin[s], begin + cells.neighbour_begin[s + 1],
                          t);
    };
    for (SiteId s = 0; s < 7; ++s) {
        for (SiteId t = 0; t < 7; ++t) EXPECT_EQ(count(s, t), count(t, s));
    }
}

TEST(CellTable, AHexagonHasItsCircularity) {
    const CellTable cells = table_of(Lattice({1, 0}, {0.5, std::sqrt(0.75)}), 1);
    EXPECT_EQ(cells.n_sides(0), 6);
    EXPECT_NEAR(cells.circularity(0), 0.9523128, 1e-6);
    EXPECT_NEAR(cells.equivalent_diameter(0), 2 * std::sqrt(std::sqrt(0.75) / M_PI), 1e-12);
}

}  // namespace
}  // namespace pcvt
