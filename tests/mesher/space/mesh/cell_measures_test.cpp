#include "mesher/space/mesh/cell_measures.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "tests/support/polyhedra.hpp"

namespace pcvt::space {
namespace {

int n_mutual(const CellTable& table, SiteId s, SiteId t) {
    const auto* const begin = table.neighbours.data();
    return static_cast<int>(
        std::count(begin + table.neighbour_begin[s], begin + table.neighbour_begin[s + 1], t));
}

TEST(SpaceCellTable, VolumesSumToTheDomain) {
    for (const testing::SpaceCase& c : testing::space_cases()) {
        SCOPED_TRACE(c.name);
        const CellTable table = cell_table(testing::complex_of(c));
        EXPECT_EQ(table.dimension, 3);
        ASSERT_EQ(table.n_cells(), c.points.cols());
        const double sum = std::accumulate(table.measure.begin(), table.measure.end(), 0.0);
        EXPECT_NEAR(sum / c.lattice.volume(), 1, 1e-12);
    }
}

TEST(SpaceCellTable, NeighboursAreMutualAndRise) {
    for (const testing::SpaceCase& c : testing::space_cases()) {
        SCOPED_TRACE(c.name);
        const CellTable table = cell_table(testing::complex_of(c));
        for (SiteId s = 0; s < table.n_cells(); ++s) {
            const auto begin = table.neighbours.begin() + table.neighbour_begin[s];
            const auto end = table.neighbours.begin() + table.neighbour_begin[s + 1];
            EXPECT_EQ(end - begin, table.sides[s]);
            EXPECT_TRUE(std::is_sorted(begin, end));
            for (auto t = begin; t != end; ++t) {
                EXPECT_EQ(n_mutual(table, s, *t), n_mutual(table, *t, s));
            }
        }
    }
}

/// The sphericity of a cell is that of the polyhedron: (36 pi V^2)^(1/3) / A.
TEST(SpaceCellTable, MeasuresTheCubeAndTheTruncatedOctahedron) {
    const Lattice cube = Lattice::box(2, 2, 2);
    Points one(3, 1);
    one << 0.3, 0.4, 0.5;
    const CellTable table = cell_table(testing::complex_of({"cube", cube, one}));
    EXPECT_NEAR(table.measure[0], 8, 1e-12);
    EXPECT_NEAR(table.surface[0], 24, 1e-12);
    EXPECT_EQ(table.sides[0], 6);
    EXPECT_EQ(table.neighbours, std::vector<SiteId>(6, 0));
    EXPECT_NEAR(table.equivalent_diameter(0), 2.4814019635976003, 1e-12);
    EXPECT_NEAR(table.roundness(0), 0.8059959770082348, 1e-12);

    Points centred(3, 2);
    centred << 0.5, 1.5, 0.5, 1.5, 0.5, 1.5;
    const CellTable octahedra = cell_table(testing::complex_of({"bcc", cube, centred}));
    EXPECT_EQ(octahedra.sides, (std::vector<int>{14, 14}));
    EXPECT_NEAR(octahedra.roundness(1), 0.9099177, 1e-7);
}

}  // namespace
}  // namespace pcvt::space
