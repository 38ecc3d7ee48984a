#include "mesher/plane/tessellation/tessellation.hpp"

#include <gmock/gmock.h>

#include <future>

#include "mesher/cells/target_areas.hpp"
#include "mesher/plane/mesh/cell_measures.hpp"
#include "mesher/plane/mesh/valence.hpp"
#include "mesher/plane/tessellation/tessellate.hpp"
#include "tests/support/example_lattices.hpp"
#include "tests/support/tile_equality.hpp"

namespace pcvt::plane {
namespace {

using testing::kSquare;

const TaggedInclusions kFibre{.shapes = {{Circle{{0.4, 0.5}, 0.25}, 1, 1}},
                              .tag_names = {"matrix", "fibre"},
                              .holes = {"fibre"}};

CvtOptions few_steps() { return {.run = {.max_iterations = 3}}; }

/// Elongated, walled, power cells, and cells round a hole.
std::vector<Tessellation> examples() {
    const Points points = uniform_points(kSquare, 60, 1);
    std::vector<Tessellation> all;
    all.push_back(tessellate(kSquare, {}, points, few_steps()));
    const Metric metric(3, 30);
    all.push_back(tessellate(metric.to_round(kSquare), {}, metric.to_round(points), few_steps()));
    all.back().elongation = Elongation{metric, kSquare};
    all.push_back(tessellate(kSquare, {Walls::kY, WallCells::kHalf},
                             uniform_points(kSquare, 300, 1), few_steps()));
    const Eigen::VectorXd areas =
        scaled_areas(draw_areas(parse_area_law("gamma:0.3"), 60, 1), 60, 1);
    all.push_back(tessellate(kSquare, {}, points, AreaCvtOptions{.areas = areas}));
    all.push_back(tessellate(kSquare, {}, kFibre, 400, 1, few_steps()));
    all.push_back(tessellate(kSquare, {Walls::kX}, kFibre, 400, 1, few_steps()));
    return all;
}

void expect_equal(const PeriodicMesh& s, const PeriodicMesh& t) {
    EXPECT_EQ(s.vertices, t.vertices);
    EXPECT_EQ(s.face_begin, t.face_begin);
    EXPECT_EQ(s.corner_vertex, t.corner_vertex);
    EXPECT_EQ(s.opposite, t.opposite);
    EXPECT_EQ(s.site, t.site);
}

void expect_equal(const CellTable& s, const CellTable& t) {
    EXPECT_EQ(s.measure, t.measure);
    EXPECT_EQ(s.surface, t.surface);
    EXPECT_EQ(s.sides, t.sides);
    EXPECT_EQ(s.neighbour_begin, t.neighbour_begin);
    EXPECT_EQ(s.neighbours, t.neighbours);
}

TEST(Tessellation, TheMeshIsTheSameBeforeAndAfterTheTable) {
    for (const Tessellation& cells : examples()) {
        const PeriodicMesh mesh = cells.mesh(MeshKind::kVoronoi);
        expect_equal(cells.table(), cell_table(mesh));
        EXPECT_EQ(cells.table().n_cells(), cells.n_sites());
        expect_equal(cells.mesh(MeshKind::kVoronoi), mesh);
        expect_equal(cells.mesh(MeshKind::kVoronoi), mesh);
    }
}

TEST(Tessellation, TheTableGivesItsCellsToTheNextMesh) {
    const Tessellation cells = tessellate(kSquare, {}, uniform_points(kSquare, 60, 1), few_steps());
    cells.table();
    const Vec2* vertices = cells.cache->cells.value().vertices.data();
    EXPECT_EQ(cells.mesh(MeshKind::kVoronoi).vertices.data(), vertices);
    EXPECT_FALSE(cells.cache->cells);
}

TEST(Tessellation, TheTableOutsideOfHolesIsThatOfTheMesh) {
    for (const Tessellation& cells : examples()) {
        expect_equal(table_outside_holes(cells),
                     cell_table(mesh_outside_holes(cells, MeshKind::kVoronoi)));
    }
}

TEST(Tessellation, SidesAreThoseOfTheMesh) {
    for (const Tessellation& cells : examples()) {
        EXPECT_EQ(cell_sides(cells), cell_sides(cells.mesh(MeshKind::kVoronoi)));
    }
}

TEST(Tessellation, ATileOfTheCellsOfTheTableIsThatOfTheTriangulation) {
    for (const Tessellation& cells : examples()) {
        for (const MeshKindRow& row : kMeshKinds) {
            // Triangles between walls would need half cells at all walls.
            if (cells.walled && row.kind == MeshKind::kDelaunay) continue;
            const TileOptions options{.kind = row.kind,
                                      .elongation = cells.elongation,
                                      .walled = cells.walled,
                                      .site_tags = cells.site_tags,
                                      .holes = cells.holes};
            const Tile expected = build_tile(cells.delaunay, options).tile;
            cells.table();
            const Tile tile = build_tile(cells, {.kind = row.kind}).tile;
            testing::expect_same_tile(tile, expected);
            EXPECT_EQ(tile.site_weights, expected.site_weights);
            EXPECT_EQ(tile.wall_edges.size(), expected.wall_edges.size());
        }
    }
}

TEST(Tessellation, AnyNumberOfThreadsMayCallIt) {
    const Tessellation cells =
        tessellate(kSquare, {}, uniform_points(kSquare, 500, 1), few_steps());
    const CellTable expected = cell_table(cells.mesh(MeshKind::kVoronoi));
    std::vector<std::future<void>> threads;
    for (int k = 0; k < 8; ++k) {
        threads.push_back(std::async(std::launch::async, [&] {
            expect_equal(cells.table(), expected);
            expect_equal(cell_table(cells.mesh(MeshKind::kVoronoi)), expected);
        }));
    }
    for (std::future<void>& thread : threads) thread.get();
}

}  // namespace
}  // namespace pcvt::plane
