#include "io/forms/seam_segments.hpp"

#include <gmock/gmock.h>

#include <set>

#include "mesher/base/error.hpp"
#include "mesher/plane/mesh/outline.hpp"
#include "mesher/plane/mesh/voronoi.hpp"
#include "mesher/plane/tile/tile_builder.hpp"
#include "tests/support/grid_tile.hpp"
#include "tests/support/lattices.hpp"
#include "tests/support/walled_tiles.hpp"

namespace pcvt {
namespace {

/// Whole-cell tiles: their ragged boundaries have two to four translations.
std::vector<plane::Tile> tiles() {
    std::vector<plane::Tile> all;
    for (const auto& [name, lattice] : testing::lattices()) {
        for (const int n : {1, 2, 3, 17}) {
            const plane::PeriodicDelaunay delaunay(
                plane::Sites(lattice, uniform_points(lattice, n, 5)));
            for (const plane::PeriodicMesh& mesh : {cell_mesh(delaunay), triangle_mesh(delaunay)}) {
                all.push_back(make_tile(mesh, whole_outline(mesh, plane::Vec2(0, 0))));
            }
        }
    }
    return all;
}

// Law (1)
TEST(SeamSegments, APartnerRunsTheOtherWayByTheOppositeOffset) {
    for (const plane::Tile& tile : tiles()) {
        const auto runs = seam_segments(tile, {});
        for (std::size_t r = 0; r < runs.size(); ++r) {
            const SeamSegment& partner = runs.at(runs[r].partner);
            EXPECT_EQ(partner.partner, static_cast<int>(r));
            EXPECT_EQ(partner.offset, -runs[r].offset);
            ASSERT_EQ(partner.vertices.size(), runs[r].vertices.size());
            const plane::Vec2 translation = tile.lattice.translation(runs[r].offset);
            for (std::size_t k = 0; k < runs[r].vertices.size(); ++k) {
                const plane::Vec2& from = tile.points[runs[r].vertices[k]];
                const plane::Vec2& to = tile.points[*(partner.vertices.rbegin() + k)];
                EXPECT_LT((from + translation - to).norm(), 1e-12 * (1 + to.norm()));
            }
        }
    }
}

// Law (2)
TEST(SeamSegments, TheyAreTheWholeLoopInStretchesAsLongAsPossible) {
    for (const plane::Tile& tile : tiles()) {
        const auto runs = seam_segments(tile, {});
        std::size_t n_edges = 0;
        for (std::size_t r = 0; r < runs.size(); ++r) {
            const SeamSegment& next = runs[(r + 1) % runs.size()];
            EXPECT_EQ(runs[r].vertices.back(), next.vertices.front());
            EXPECT_NE(runs[r].offset, next.offset);
            n_edges += runs[r].vertices.size() - 1;
        }
        EXPECT_EQ(n_edges, 2 * tile.edge_pairs.size());
    }
}

// Law (3)
TEST(SeamSegments, OrbitsOfEndsAreEnds) {
    for (const plane::Tile& tile : tiles()) {
        std::set<int> ends;
        for (const SeamSegment& run : seam_segments(tile, {})) ends.insert(run.vertices.front());
        for (const plane::VertexPair& pair : tile.vertex_pairs) {
            EXPECT_EQ(ends.count(pair.v), ends.count(pair.w));
        }
    }
}

TEST(SeamSegments, AParallelogramHasFourWithTheTileOnTheirLeft) {
    const plane::Tile tile =
        testing::triangle_grid_tile(plane::Lattice({1, 0}, {0.37, 0.81}), 3, 2);
    const auto runs = seam_segments(tile, {});
    ASSERT_EQ(runs.size(), 4U);
    EXPECT_THAT(runs[0].vertices, ::testing::ElementsAre(0, 1, 2, 3));
    EXPECT_EQ(runs[0].offset, (plane::Offset{0, 1}));
    EXPECT_EQ(seam_name(runs[1].offset), "seam_-1_0");
    EXPECT_EQ(runs[1].partner, 3);
}

TEST(SeamSegments, StretchesOnAWallLieOnItAndHaveNoPartner) {
    for (const Walls walls : {Walls::kX, Walls::kY, Walls::kXY}) {
        for (const plane::Tile& tile : testing::walled_tiles(walls)) {
            const plane::MidsideNodes middles =
                tile.order == 2 ? midside_nodes(tile) : plane::MidsideNodes{};
            const auto runs = seam_segments(tile, middles);
            std::set<plane::WallEdge> edges;
            for (std::size_t r = 0; r < runs.size(); ++r) {
                const SeamSegment& next = runs[(r + 1) % runs.size()];
                EXPECT_TRUE(runs[r].wall != next.wall || runs[r].offset != next.offset);
                if (!runs[r].wall) {
                    EXPECT_EQ(runs.at(runs[r].partner).partner, static_cast<int>(r));
                    continue;
                }
                EXPECT_EQ(runs[r].offset, plane::Offset{});
                EXPECT_EQ(runs[r].partner, -1);
                const WallSideRow& wall = wall_side_row(runs[r].wall->side());
                for (std::size_t k = 0; k + 1 < runs[r].vertices.size(); ++k) {
                    edges.insert({*runs[r].wall, runs[r].vertices[k], runs[r].vertices[k + 1]});
                }
                for (const int v : runs[r].middles) {
                    EXPECT_EQ(middles.points.at(v - tile.n_vertices())[wall.axis],
                              wall_line(wall, tile.lattice));
                }
                EXPECT_EQ(runs[r].middles.size() + 1,
                          tile.order == 2 ? runs[r].vertices.size() : 1);
            }
            EXPECT_EQ(edges, std::set(tile.wall_edges.begin(), tile.wall_edges.end()));
        }
    }
}

TEST(SeamSegments, ABoxHasFourWalls) {
    for (const plane::Tile& tile : testing::walled_tiles(Walls::kXY)) {
        std::multiset<WallSide> sides;
        for (const SeamSegment& run : seam_segments(tile, {})) {
            sides.insert(run.wall.value().side());
        }
        EXPECT_THAT(sides, ::testing::ElementsAre(WallSide::kLeft, WallSide::kRight,
                                                  WallSide::kBottom, WallSide::kTop));
    }
}

TEST(SeamSegments, ABoundaryThatIsNoLoopIsOurFault) {
    plane::Tile tile = testing::grid_tile(plane::Lattice::rectangle(1, 1), 2, 2);
    tile.edge_pairs.pop_back();
    EXPECT_THROW(seam_segments(tile, {}), InternalError);
    tile.edge_pairs.clear();
    EXPECT_THROW(seam_segments(tile, {}), InternalError);
}

}  // namespace
}  // namespace pcvt
