#include "mesher/plane/mesh/valence.hpp"

#include <gmock/gmock.h>

#include <numeric>

#include "mesher/plane/mesh/voronoi.hpp"
#include "mesher/plane/tile/tile_valence.hpp"
#include "tests/support/grid_tile.hpp"
#include "tests/support/lattices.hpp"

namespace pcvt::plane {
namespace {

using ::testing::Each;
using ::testing::IsEmpty;
using ::testing::Pair;
using ::testing::UnorderedElementsAre;

const Lattice kSkewed({1, 0}, {7, 1});

/// Returns a unit square whose lower side is split at x = `cut`.
Tile split_square(double cut) {
    Tile tile{.lattice = Lattice::rectangle(1, 1), .kind = MeshKind::kVoronoi};
    tile.points = {{0, 0}, {cut, 0}, {1, 0}, {1, 1}, {0, 1}};
    tile.faces.add(std::vector{0, 1, 2, 3, 4});
    tile.face_site = {0};
    return tile;
}

TEST(CellSides, ParallelogramHasFour) {
    EXPECT_THAT(cell_sides(testing::grid_tile(kSkewed, 3, 2)), Each(4));
}

TEST(CellSides, EdgeCountsOnlyIfLongerThanTheShortEdge) {
    EXPECT_THAT(cell_sides(split_square(1.01 * kShortEdge)), Each(5));
    EXPECT_THAT(cell_sides(split_square(0.99 * kShortEdge)), Each(4));
}

TEST(CellSides, ShortnessIsMeasuredInTheSpacingOfTheTile) {
    Tile tile = split_square(1.01 * kShortEdge);
    tile.lattice = Lattice::rectangle(1e3, 1e3);
    for (Vec2& p : tile.points) p *= 1e3;
    EXPECT_THAT(cell_sides(tile), Each(5));
}

TEST(VertexValences, EveryCopyOfAGridPointHasSix) {
    for (const int columns : {1, 2, 5}) {
        EXPECT_THAT(vertex_valences(testing::triangle_grid_tile(kSkewed, columns, 3)), Each(6));
    }
}

TEST(VertexValences, FlippedEdgeMovesOneTriangleFromTwoSitesToTwoOthers) {
    Tile tile = testing::triangle_grid_tile(Lattice::rectangle(1, 1), 4, 4);
    // Flip the diagonal of the parallelogram (1, 1) with the vertices 6, 7, 12, 11, all off the
    // seam.
    const int first = 3 * 2 * 5;
    ASSERT_EQ(tile.faces.corners[first], 6);
    const std::vector<int> flipped = {6, 7, 11, 7, 12, 11};
    std::copy(flipped.begin(), flipped.end(), tile.faces.corners.begin() + first);
    const std::vector<int> valence = vertex_valences(tile);
    EXPECT_EQ(valence[6], 5);
    EXPECT_EQ(valence[12], 5);
    EXPECT_EQ(valence[7], 7);
    EXPECT_EQ(valence[11], 7);
    EXPECT_EQ(valence[0], 6);
}

TEST(Histogram, CountsEachNumberOfSides) {
    EXPECT_THAT(histogram({6, 5, 7, 6, 6}),
                UnorderedElementsAre(Pair(5, 1), Pair(6, 3), Pair(7, 1)));
    EXPECT_THAT(histogram({}), IsEmpty());
}

TEST(CellSides, OfATriangulationAreThoseOfItsCells) {
    for (const auto& [name, lattice] : testing::lattices()) {
        for (const int n : {1, 2, 3, 8, 100}) {
            const PeriodicDelaunay delaunay(Sites(lattice, uniform_points(lattice, n, 5)));
            EXPECT_EQ(cell_sides(delaunay), cell_sides(cell_mesh(delaunay))) << name << n;
        }
        Points grid(2, 12);
        for (int k = 0; k < 12; ++k) grid.col(k) = lattice.to_position({k % 3 / 3.0, k / 3 / 4.0});
        const PeriodicDelaunay delaunay(Sites(lattice, grid));
        EXPECT_EQ(cell_sides(delaunay), cell_sides(cell_mesh(delaunay))) << name;
    }
}

}  // namespace
}  // namespace pcvt::plane
