#include "mesher/plane/mesh/short_edges.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "mesher/plane/geometry/polygon.hpp"
#include "mesher/plane/mesh/outline.hpp"
#include "mesher/plane/mesh/voronoi.hpp"
#include "mesher/plane/proof/validate.hpp"
#include "mesher/plane/tile/tile_builder.hpp"
#include "tests/support/lattices.hpp"
#include "tests/support/random_meshes.hpp"
#include "tests/support/special_sites.hpp"

namespace pcvt::plane {
namespace {

using testing::lattices;
using testing::random_cells;

double spacing(const PeriodicMesh& mesh) { return std::sqrt(mesh.lattice.area() / mesh.n_faces()); }

double length(const PeriodicMesh& mesh, int c) {
    return (mesh.point(mesh.next(c)) - mesh.point(c)).norm();
}

int count_short(const PeriodicMesh& mesh, double shortest) {
    int count = 0;
    for (int c = 0; c < mesh.n_corners(); ++c) count += length(mesh, c) < shortest;
    return count / 2;
}

// Checks law 1 by the proof behind `pcvt check`.
void expect_same_torus(const PeriodicMesh& mesh, const PeriodicMesh& before) {
    ASSERT_EQ(mesh.n_vertices() - mesh.n_corners() / 2 + mesh.n_faces(), 0);
    ASSERT_EQ(mesh.site, before.site);
    const Tile flat = make_tile(mesh, whole_outline(mesh, {0, 0}));
    const TileProof proof = prove_tile(flat, Precision::kDouble);
    compare_vertex_pairs(flat, proof);
    compare_edge_pairs(flat, proof);
}

TEST(ShortEdges, LeaveATorusOnEveryLattice) {
    for (const auto& [name, lattice] : lattices()) {
        for (const int n : {1, 2, 3, 5, 8, 60}) {
            for (const double shortest : {0.02, 0.1, 0.4}) {
                SCOPED_TRACE(name + " n = " + std::to_string(n));
                const PeriodicMesh cells = random_cells(lattice, n, 4);
                expect_same_torus(without_short_edges(cells, shortest * spacing(cells)), cells);
            }
        }
    }
}

TEST(ShortEdges, LeaveATorusWhereSitesAreCocircular) {
    for (const auto& [name, sites] : testing::special_sites()) {
        SCOPED_TRACE(name);
        const PeriodicMesh cells = cell_mesh(PeriodicDelaunay(sites));
        expect_same_torus(without_short_edges(cells, 0.3 * spacing(cells)), cells);
    }
}

// Law 2, where many edges are short and no cell prevents their removal.
TEST(ShortEdges, AreRemovedWhereNoCellPreventsIt) {
    const PeriodicMesh cells = random_cells(Lattice::rectangle(1, 1), 2000, 5);
    const double shortest = 0.1 * spacing(cells);
    ASSERT_GT(count_short(cells, shortest), 400);
    EXPECT_EQ(count_short(without_short_edges(cells, shortest), shortest), 0);
}

// Law 2: the small cell between its four neighbours cannot be removed.
TEST(ShortEdges, OfACellThatWouldVanishStay) {
    Points points(2, 5);
    points << 0.5, 0.51, 0.5, 0.49, 0.5, 0.5, 0.5, 0.51, 0.5, 0.49;
    const PeriodicMesh cells = cell_mesh(PeriodicDelaunay(Sites(Lattice::rectangle(1, 1), points)));
    const PeriodicMesh left = without_short_edges(cells, 0.1);
    expect_same_torus(left, cells);
    EXPECT_GE(left.face_begin[1] - left.face_begin[0], 3);
    EXPECT_GE(count_short(left, 0.1), 3);
}

double area(const PeriodicMesh& mesh, int f) {
    Polygon polygon;
    for (int c = mesh.face_begin[f]; c < mesh.face_begin[f + 1]; ++c) {
        polygon.push_back(mesh.point(c));
    }
    return polygon_area(polygon);
}

TEST(ShortEdges, SquashNoCell) {
    const PeriodicMesh cells = random_cells(Lattice::rectangle(1, 1), 3000, 8);
    const PeriodicMesh left = without_short_edges(cells, 0.4 * spacing(cells));
    double least = 1;
    for (int f = 0; f < cells.n_faces(); ++f) {
        least = std::min(least, area(left, f) / area(cells, f));
    }
    // Each removal leaves half of a cell, and few cells lose more than one edge.
    EXPECT_GT(least, 0.35);
}

// Law 3.
// Law 5.
TEST(ShortEdges, VerticesThatStayKeepTheirEdges) {
    const PeriodicMesh cells = random_cells(Lattice({1, 0}, {0.37, 0.81}), 500, 4);
    std::vector<bool> still(cells.vertices.size());
    for (std::size_t v = 0; v < still.size(); v += 3) still[v] = true;
    const PeriodicMesh left = without_short_edges(cells, 0.3 * spacing(cells), still);
    EXPECT_LT(left.n_vertices(), cells.n_vertices() - 50);
    std::set<std::pair<double, double>> kept;
    for (const Vec2& p : left.vertices) kept.emplace(p.x(), p.y());
    for (std::size_t v = 0; v < still.size(); ++v) {
        const Vec2& p = cells.vertices[v];
        EXPECT_TRUE(!still[v] || kept.contains({p.x(), p.y()})) << v;
    }
}

TEST(ShortEdges, MoveOnlyTheirOwnEnds) {
    const PeriodicMesh cells = random_cells(Lattice({1, 0}, {0.37, 0.81}), 300, 6);
    const double shortest = 0.05 * spacing(cells);
    std::set<std::pair<double, double>> at_short_edges;
    for (int c = 0; c < cells.n_corners(); ++c) {
        if (length(cells, c) >= shortest) continue;
        for (const int d : {c, cells.next(c)}) {
            const Vec2& p = cells.vertices[cells.corner_vertex[d]];
            at_short_edges.emplace(p.x(), p.y());
        }
    }
    const PeriodicMesh left = without_short_edges(cells, shortest);
    std::set<std::pair<double, double>> kept;
    for (const Vec2& p : left.vertices) kept.emplace(p.x(), p.y());
    int n_still = 0;
    for (const Vec2& p : cells.vertices) {
        if (at_short_edges.contains({p.x(), p.y()})) continue;
        ++n_still;
        EXPECT_TRUE(kept.contains({p.x(), p.y()}));
    }
    EXPECT_GT(n_still, 300);
}

// Law 4: the vertex of four cocircular sites, (0.5, 0.5), counts for two of three triangles; the
// third one has its circumcentre at (0.5, 0.55).
TEST(ShortEdges, AVertexOfFourCellsCountsTwice) {
    Points points(2, 5);
    points << 0.3, 0.7, 0.3, 0.7, 0.5, 0.3, 0.3, 0.7, 0.7, 0.8;
    const PeriodicMesh cells = cell_mesh(PeriodicDelaunay(Sites(Lattice::rectangle(1, 1), points)));
    const PeriodicMesh joined = without_short_edges(cells, 0.06);
    ASSERT_EQ(joined.n_vertices(), cells.n_vertices() - 1);
    double nearest = 1;
    for (const Vec2& p : joined.vertices) {
        nearest = std::min(nearest, (p - Vec2(0.5, 0.5 + 0.05 / 3)).norm());
    }
    EXPECT_LT(nearest, 1e-12);
}

TEST(ShortEdges, LengthZeroLeavesTheMeshUnchanged) {
    const PeriodicMesh cells = random_cells(Lattice::rectangle(1, 1), 40, 7);
    const PeriodicMesh same = without_short_edges(cells, 0);
    EXPECT_EQ(same.corner_vertex, cells.corner_vertex);
    EXPECT_EQ(same.corner_offset, cells.corner_offset);
    EXPECT_EQ(same.opposite, cells.opposite);
}

}  // namespace
}  // namespace pcvt::plane
