#include "io/forms/cell_entities.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "io/forms/triangle_cells.hpp"
#include "mesher/plane/tile/build_tile.hpp"
#include "tests/support/grid_tile.hpp"
#include "tests/support/solver_tiles.hpp"
#include "tests/support/tile_equality.hpp"
#include "tests/support/walled_tiles.hpp"

namespace pcvt {
namespace {

using Edge = std::pair<int, int>;

Edge edge(int v, int w) { return {std::min(v, w), std::max(v, w)}; }

plane::Tile tile_of(int n, const plane::TileOptions& options) {
    const plane::Lattice lattice({1, 0}, {0.3, 0.9});
    return build_tile(plane::PeriodicDelaunay(plane::Sites(lattice, uniform_points(lattice, n, 5))),
                      options)
        .tile;
}

/// Tiles in which cells are cut, meet their own images, or own no triangle.
std::vector<plane::Tile> entity_tiles() {
    std::vector<plane::Tile> all = testing::solver_tiles(testing::awkward_lattices());
    for (const int n : {1, 2, 7, 60}) {
        all.push_back(tile_of(n, {.kind = plane::MeshKind::kDelaunay}));
        all.push_back(tile_of(n, {.kind = plane::MeshKind::kGrains, .order = 2, .repeat = {2, 1}}));
        all.push_back(
            tile_of(n, {.kind = plane::MeshKind::kGrains, .outline = plane::Outline::kBox}));
    }
    for (const Walls walls : {Walls::kX, Walls::kY, Walls::kXY}) {
        for (const plane::Tile& tile : testing::walled_tiles(walls)) all.push_back(tile);
    }
    return all;
}

/// The triangles at each edge.
std::map<Edge, std::vector<int>> faces_at_edges(const plane::Tile& tile) {
    std::map<Edge, std::vector<int>> faces;
    for (int f = 0; f < tile.n_faces(); ++f) {
        const auto corners = tile.faces[f];
        for (int k = 0; k < 3; ++k) faces[edge(corners[k], corners[(k + 1) % 3])].push_back(f);
    }
    return faces;
}

std::map<Edge, const CellCurve*> curves_at_edges(const CellEntities& entities) {
    std::map<Edge, const CellCurve*> curves;
    for (const CellCurve& curve : entities.curves) {
        for (std::size_t k = 0; k + 1 < curve.vertices.size(); ++k) {
            const Edge e = edge(curve.vertices[k], curve.vertices[k + 1]);
            EXPECT_TRUE(curves.emplace(e, &curve).second);
        }
    }
    return curves;
}

TEST(CellEntities, Law1EdgesBetweenCellsAndNoOthersAreOnCurves) {
    for (const plane::Tile& tile : entity_tiles()) {
        const CellEntities entities = cell_entities(tile, solver_nodes(tile));
        const TriangleCells cells(tile);
        const auto curves = curves_at_edges(entities);
        for (const auto& [ends, faces] : faces_at_edges(tile)) {
            const auto found = curves.find(ends);
            const bool is_boundary = faces.size() == 1;
            ASSERT_EQ(found != curves.end(), is_boundary || !cells.same(faces[0], faces[1]));
            if (found == curves.end()) continue;
            EXPECT_EQ(found->second->bounds_tile(), is_boundary);
            std::multiset<SiteId> sites{entities.surfaces[found->second->left].site};
            if (!is_boundary) sites.insert(entities.surfaces[found->second->right].site);
            std::multiset<SiteId> wanted;
            for (const int f : faces) wanted.insert(cells.site(f));
            EXPECT_EQ(sites, wanted);
        }
    }
}

TEST(CellEntities, Law2CurvesEndAtPointsThatTheSeamIdentifies) {
    for (const plane::Tile& tile : entity_tiles()) {
        const CellEntities entities = cell_entities(tile, solver_nodes(tile));
        const std::set<int> points(entities.points.begin(), entities.points.end());
        for (std::size_t k = 0; k < entities.curves.size(); ++k) {
            const CellCurve& curve = entities.curves[k];
            for (const int v : curve.vertices) {
                const bool is_end = v == curve.vertices.front() || v == curve.vertices.back();
                ASSERT_EQ(points.contains(v), is_end);
            }
            if (curve.wall) {
                const WallSideRow& wall = wall_side_row(curve.wall->side());
                for (const int v : curve.vertices) {
                    EXPECT_EQ(tile.points[v][wall.axis], wall_line(wall, tile.lattice));
                }
                EXPECT_EQ(curve.partner, -1);
            }
            if (!curve.is_seam()) continue;
            const CellCurve& partner = entities.curves[curve.partner];
            EXPECT_EQ(partner.partner, static_cast<int>(k));
            EXPECT_EQ(partner.offset, -curve.offset);
            ASSERT_EQ(partner.vertices.size(), curve.vertices.size());
            const plane::Vec2 t = tile.lattice.translation(curve.offset);
            for (std::size_t v = 0; v < curve.vertices.size(); ++v) {
                const plane::Vec2& p = tile.points[curve.vertices[v]];
                const plane::Vec2& q = tile.points[partner.vertices[curve.vertices.size() - 1 - v]];
                EXPECT_LT((q - p - t).norm(), 1e-12 * (p.norm() + t.norm()));
            }
        }
    }
}

TEST(CellEntities, Law3EachNodeBelongsToOneEntityAndEachTriangleToOneSurface) {
    for (const plane::Tile& tile : entity_tiles()) {
        const SolverNodes nodes = solver_nodes(tile);
        const CellEntities entities = cell_entities(tile, nodes);
        std::vector<int> owners(nodes.points.size(), 0);
        for (const int v : entities.points) ++owners[v];
        for (const CellCurve& curve : entities.curves) {
            for (std::size_t k = 1; k + 1 < curve.vertices.size(); ++k) ++owners[curve.vertices[k]];
            for (const int v : curve.middles) ++owners[v];
            EXPECT_EQ(curve.middles.size(), tile.order == 2 ? curve.vertices.size() - 1 : 0);
        }
        std::vector<int> triangles;
        for (const CellSurface& cell : entities.surfaces) {
            for (const int v : cell.nodes) ++owners[v];
            triangles.insert(triangles.end(), cell.triangles.begin(), cell.triangles.end());
            EXPECT_FALSE(cell.triangles.empty());
        }
        EXPECT_EQ(owners, std::vector<int>(nodes.points.size(), 1));
        std::sort(triangles.begin(), triangles.end());
        EXPECT_EQ(std::unique(triangles.begin(), triangles.end()), triangles.end());
        EXPECT_EQ(static_cast<int>(triangles.size()), tile.n_faces());
    }
}

}  // namespace
}  // namespace pcvt
