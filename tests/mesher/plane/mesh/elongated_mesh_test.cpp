#include "mesher/plane/mesh/elongated_mesh.hpp"

#include <gtest/gtest.h>

#include "mesher/base/error.hpp"
#include "mesher/cells/target_areas.hpp"
#include "mesher/plane/cvt/area_cvt.hpp"
#include "mesher/plane/mesh/cell_measures.hpp"
#include "mesher/plane/mesh/voronoi.hpp"
#include "mesher/plane/proof/generated_tile.hpp"
#include "mesher/plane/tile/build_tile.hpp"
#include "tests/support/lattices.hpp"

namespace pcvt::plane {
namespace {

// Law 1.
TEST(ElongatedMesh, CellsKeepTheirAreasAndTheirNeighbours) {
    const Metric metric(3, 30);
    for (const auto& [name, lattice] : testing::lattices()) {
        const Lattice round = metric.to_round(lattice);
        const Points points = metric.to_round(uniform_points(lattice, 40, 1));
        const PeriodicMesh there = cell_mesh(PeriodicDelaunay(Sites(round, points)));
        const PeriodicMesh here = from_round(there, metric, lattice);
        EXPECT_EQ(here.lattice.a(), lattice.a());
        EXPECT_EQ(here.corner_offset, there.corner_offset);
        const CellTable before = cell_table(there);
        const CellTable after = cell_table(here);
        for (SiteId s = 0; s < 40; ++s) {
            EXPECT_NEAR(after.measure[s], before.measure[s], 1e-11 * before.measure[s]) << name;
        }
    }
}

TEST(ElongatedMesh, CellsAreLongAlongTheDirection) {
    const Metric metric(3, 0);
    const Lattice unit = Lattice::rectangle(1, 1);
    const Points points = metric.to_round(uniform_points(unit, 500, 1));
    const PeriodicDelaunay round(Sites(metric.to_round(unit), points));
    const PeriodicMesh cells = from_round(cell_mesh(round), metric, unit);
    double width = 0;
    double height = 0;
    for (int c = 0; c < cells.n_corners(); ++c) {
        const Vec2 edge = cells.point(cells.next(c)) - cells.point(c);
        width += std::abs(edge.x());
        height += std::abs(edge.y());
    }
    EXPECT_NEAR(width / height, 3, 0.15);
}

// Law 2, by the proof of tiles, with and without weights.
TEST(ElongatedMesh, TilesAreProvedInTheMetric) {
    for (const auto& [name, lattice] : testing::lattices()) {
        const Metric metric(2.5, 20);
        const Eigen::VectorXd areas =
            scaled_areas(draw_areas(parse_area_law("lognormal:0.42"), 30, 1), 30, lattice.area());
        const AreaCvtResult result = compute_area_cvt(
            metric.to_round(lattice), metric.to_round(uniform_points(lattice, 30, 2)),
            {.areas = areas, .run = {.max_iterations = 3}});
        for (const MeshKind kind : {MeshKind::kVoronoi, MeshKind::kDelaunay, MeshKind::kGrains}) {
            SCOPED_TRACE(name);
            TileOptions options{.kind = kind};
            options.elongation = Elongation{metric, lattice};
            BuiltTile built = build_tile(result.delaunay, options);
            EXPECT_EQ(built.tile.lattice.b(), lattice.b());
            EXPECT_NO_THROW(verify_generated_tile(built.tile));
            if (kind != MeshKind::kVoronoi) continue;
            built.tile.metric = Metric();
            EXPECT_THROW(verify_generated_tile(built.tile), InternalError);
        }
    }
}

}  // namespace
}  // namespace pcvt::plane
