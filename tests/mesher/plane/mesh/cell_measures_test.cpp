#include "mesher/plane/mesh/cell_measures.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <set>

#include "mesher/plane/mesh/voronoi.hpp"
#include "tests/support/lattices.hpp"

namespace pcvt::plane {
namespace {

CellTable table_of(const Lattice& lattice, int n) {
    return cell_table(cell_mesh(PeriodicDelaunay(Sites(lattice, uniform_points(lattice, n, 3)))));
}

TEST(CellTable, Law1TheAreasSumToThatOfTheDomain) {
    for (const auto& [name, lattice] : testing::lattices()) {
        const CellTable cells = table_of(lattice, 40);
        const double sum = std::accumulate(cells.measure.begin(), cells.measure.end(), 0.0);
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

TEST(CellTable, Law3NeighboursAreThoseOfTheDelaunayTriangulation) {
    const Lattice lattice({1, 0}, {0.37, 0.81});
    for (const int n : {1, 2, 7, 40}) {
        const PeriodicDelaunay delaunay(Sites(lattice, uniform_points(lattice, n, 3)));
        const PeriodicMesh triangles = triangle_mesh(delaunay);
        std::vector<std::multiset<SiteId>> wanted(n);
        for (int c = 0; c < triangles.n_corners(); ++c) {
            wanted[triangles.corner_vertex[c]].insert(triangles.corner_vertex[triangles.next(c)]);
        }
        const CellTable cells = cell_table(cell_mesh(delaunay));
        for (SiteId s = 0; s < n; ++s) {
            const auto begin = cells.neighbours.begin() + cells.neighbour_begin[s];
            EXPECT_EQ(std::multiset<SiteId>(begin, begin + cells.n_neighbours(s)), wanted[s]);
        }
    }
}

TEST(CellTable, AHexagonHasItsCircularity) {
    const CellTable cells = table_of(Lattice({1, 0}, {0.5, std::sqrt(0.75)}), 1);
    EXPECT_EQ(cells.sides[0], 6);
    EXPECT_NEAR(cells.roundness(0), 0.9523128, 1e-6);
    EXPECT_NEAR(cells.equivalent_diameter(0), 2 * std::sqrt(std::sqrt(0.75) / M_PI), 1e-12);
}

}  // namespace
}  // namespace pcvt::plane
