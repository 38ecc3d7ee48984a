#include "mesher/plane/mesh/area_fit.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "mesher/cells/target_areas.hpp"
#include "mesher/plane/geometry/polygon.hpp"
#include "mesher/plane/mesh/short_edges.hpp"
#include "mesher/plane/mesh/voronoi.hpp"
#include "mesher/plane/proof/generated_tile.hpp"
#include "tests/support/lattices.hpp"
#include "tests/support/power_tiles.hpp"

namespace pcvt::plane {
namespace {

using testing::CellShape;

const CellShape kRound{"power", "lognormal:0.42"};
const CellShape kElongated{"elongated power", "lognormal:0.42", Metric(3, 30)};

BuiltTile built(const Lattice& lattice, const AreaCvtResult& cells, const CellShape& shape,
                TileOptions options) {
    if (!shape.metric.is_round()) options.elongation = Elongation{shape.metric, lattice};
    return build_tile(cells.delaunay, options);
}

/// The largest relative difference between the areas of the faces and their targets.
double largest_error(const Tile& tile, int n, int seed, const CellShape& shape) {
    const AreaLaw law = parse_area_law(shape.law);
    Eigen::VectorXd left =
        scaled_areas(draw_areas(law, n, seed), n, tile.lattice.area() / (tile.columns * tile.rows));
    const Eigen::VectorXd wanted = left;
    for (int f = 0; f < tile.n_faces(); ++f) {
        Polygon polygon;
        for (const int v : tile.faces[f]) polygon.push_back(tile.points[v]);
        left[tile.face_site[f]] -= polygon_area(polygon) / (tile.columns * tile.rows);
    }
    return (left.array().abs() / wanted.array()).maxCoeff();
}

/// Expects that the tile is proved and has the areas.
void expect_areas(const BuiltTile& built, int n, int seed, const CellShape& shape) {
    verify_generated_tile(built.tile);
    EXPECT_LE(largest_error(built.tile, n, seed, shape), 3e-10);
    EXPECT_LE(*built.figures.area_error, 1e-10);
}

// Laws 2 and 3, by the proof of tiles.
TEST(AreaFit, GrainsHaveTheTargetAreas) {
    for (const auto& [name, lattice] : testing::lattices()) {
        for (const CellShape& shape : {kRound, kElongated}) {
            for (const int n : {1, 2, 3, 5, 8, 60, 200}) {
                SCOPED_TRACE(name + " " + shape.name + " n = " + std::to_string(n));
                const AreaCvtResult cells = testing::power_cells(lattice, n, n, shape, 4);
                TileOptions options{.kind = MeshKind::kGrains, .grain_per_edge = 1};
                expect_areas(built(lattice, cells, shape, options), n, n, shape);
                options.outline = Outline::kBox;
                expect_areas(built(lattice, cells, shape, options), n, n, shape);
            }
        }
    }
}

TEST(AreaFit, RepeatedGrainsHaveThemToo) {
    const Lattice lattice({1, 0}, {0.37, 0.81});
    const AreaCvtResult cells = testing::power_cells(lattice, 50, 1, kRound, 4);
    TileOptions options{.kind = MeshKind::kGrains, .repeat = {2, 3}};
    expect_areas(built(lattice, cells, kRound, options), 50, 1, kRound);
    options.outline = Outline::kBox;
    expect_areas(built(lattice, cells, kRound, options), 50, 1, kRound);
}

TEST(AreaFit, CellsInABoxHaveThemWhereverItLies) {
    for (const auto& [name, lattice] : testing::lattices()) {
        for (int seed = 0; seed < 4; ++seed) {
            SCOPED_TRACE(name + " seed " + std::to_string(seed));
            const AreaCvtResult cells = testing::power_cells(lattice, 40, seed, kRound, 4);
            TileOptions options{.outline = Outline::kBox, .short_edges = 0.05};
            options.kind = seed % 2 == 0 ? MeshKind::kGrains : MeshKind::kVoronoi;
            options.origin = lattice.to_position({0.1 * seed, -0.3 * seed});
            options.finds_origin = seed == 3;
            expect_areas(built(lattice, cells, kRound, options), 40, seed, kRound);
        }
    }
}

// Weights are found for the usual snapping distance: no corner lies near the box but not on it.
TEST(AreaFit, CornersNearABoxLieOnIt) {
    const Lattice lattice = Lattice::rectangle(1, 1);
    int n_moved = 0;
    for (int seed = 0; seed < 40; ++seed) {
        SCOPED_TRACE(seed);
        const AreaCvtResult cells = testing::power_cells(lattice, 200, seed, kRound, 4);
        const PeriodicMesh joined =
            without_short_edges(cell_mesh(cells.delaunay), 0.02 / std::sqrt(200));
        const double snap = 0.03 / std::sqrt(200);
        const FittedCells fitted = fit_areas_in_box(cell_mesh(cells.delaunay), joined, Metric(),
                                                    cells.delaunay.weights(), {.snap = snap});
        EXPECT_LE(fitted.largest_relative_error, 1e-10);
        for (std::size_t v = 0; v < fitted.cells.vertices.size(); ++v) {
            const Vec2 off =
                (fitted.cells.vertices[v].array() - fitted.cells.vertices[v].array().round()).abs();
            const OnLines on = fitted.cut->snaps.vertices[v];
            n_moved += on[0] || on[1];
            EXPECT_TRUE(on[0] || on[1] || off.minCoeff() > snap / 3 - 1e-15);
            if (on[0] == on[1]) continue;
            EXPECT_LT(off[on[1] ? 1 : 0], kHeldSnap * snap);
        }
    }
    EXPECT_GT(n_moved, 60);
}

// Law 1.
TEST(AreaFit, TopologyAndFramesStay) {
    const Lattice lattice({1, 0}, {0.37, 0.81});
    const AreaCvtResult result = testing::power_cells(lattice, 100, 2, kRound, 2);
    const PeriodicMesh cells = cell_mesh(result.delaunay);
    const PeriodicMesh joined = without_short_edges(cells, 0.05 * 0.09);
    ASSERT_LT(joined.n_vertices(), cells.n_vertices());
    const FittedCells fitted = fit_areas(cells, joined, Metric(), result.delaunay.weights());
    EXPECT_EQ(fitted.cells.corner_vertex, joined.corner_vertex);
    EXPECT_EQ(fitted.cells.corner_offset, joined.corner_offset);
    EXPECT_EQ(fitted.cells.site, joined.site);
    EXPECT_LE(fitted.largest_relative_error, 1e-10);
    EXPECT_GT((areas_by_site(joined, 100) - areas_by_site(cells, 100)).cwiseAbs().maxCoeff(), 1e-5);
    // The domain has its area for any weights.
    EXPECT_NEAR(areas_by_site(fitted.cells, 100).sum(), lattice.area(), 1e-12);
}

// Law 1, where too many edges are removed for any weights to give the areas.
TEST(AreaFit, CellsStaySimpleWhereAreasAreNotReached) {
    const Lattice lattice = Lattice::rectangle(1, 1);
    int n_missed = 0;
    for (int seed = 0; seed < 30; ++seed) {
        SCOPED_TRACE(seed);
        const AreaCvtResult result = testing::power_cells(lattice, 100, seed, kRound, 4);
        const PeriodicMesh cells = cell_mesh(result.delaunay);
        const PeriodicMesh joined = without_short_edges(cells, 0.035);
        const FittedCells fitted = fit_areas(cells, joined, Metric(), result.delaunay.weights());
        n_missed += fitted.largest_relative_error > 1e-10;
        const PeriodicMesh& mesh = fitted.cells;
        for (int f = 0; f < mesh.n_faces(); ++f) {
            Polygon polygon;
            for (int c = mesh.face_begin[f]; c < mesh.face_begin[f + 1]; ++c) {
                polygon.push_back(mesh.point(c));
            }
            EXPECT_GT(polygon_area(polygon), 0);
            EXPECT_FALSE(crosses_itself(polygon, 0));
        }
    }
    EXPECT_GT(n_missed, 0);
}

TEST(AreaFit, CellsWithTheirAreasStayAsTheyAre) {
    const Lattice lattice = Lattice::rectangle(2, 1);
    const AreaCvtResult result = testing::power_cells(lattice, 30, 2, kRound, 2);
    const PeriodicMesh cells = cell_mesh(result.delaunay);
    const FittedCells fitted = fit_areas(cells, cells, Metric(), result.delaunay.weights());
    EXPECT_EQ(fitted.weights, result.delaunay.weights());
    EXPECT_EQ(fitted.cells.vertices, cells.vertices);
}

}  // namespace
}  // namespace pcvt::plane
