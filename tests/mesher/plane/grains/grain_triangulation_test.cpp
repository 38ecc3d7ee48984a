#include "mesher/plane/grains/grain_triangulation.hpp"

#include <gtest/gtest.h>

#include "mesher/plane/geometry/polygon.hpp"
#include "mesher/plane/grains/corner_guards.hpp"
#include "mesher/plane/grains/grain_smoothing.hpp"
#include "mesher/plane/grains/triangle_shape.hpp"
#include "mesher/plane/mesh/voronoi.hpp"
#include "tests/support/lattices.hpp"

namespace pcvt::plane {
namespace {

using Edge = GrainTriangulation::Edge;

PeriodicMesh random_cells(const Lattice& lattice, int n, std::uint64_t seed) {
    return cell_mesh(PeriodicDelaunay(Sites(lattice, uniform_points(lattice, n, seed))));
}

/// Checks topology and orientation, and that both sides of an edge agree up to a translation.
void expect_triangulation(const GrainTriangulation& grains) {
    ASSERT_EQ(grains.n_vertices() - grains.n_halfedges() / 2 + grains.n_triangles(), 0);
    for (int h = 0; h < grains.n_halfedges(); ++h) {
        const int o = grains.opposite(h);
        ASSERT_EQ(grains.opposite(o), h);
        ASSERT_EQ(grains.edge(o), grains.edge(h));
        ASSERT_EQ(grains.vertex(o), grains.vertex(GrainTriangulation::next(h)));
        ASSERT_TRUE(grains.edge(h) != Edge::kFree || grains.cell(h / 3) == grains.cell(o / 3));
        const Vec2 here = grains.point(GrainTriangulation::next(h)) - grains.point(h);
        const Vec2 there = grains.point(GrainTriangulation::next(o)) - grains.point(o);
        ASSERT_LT((here + there).norm(), 1e-12);
    }
    for (int t = 0; t < grains.n_triangles(); ++t) {
        ASSERT_GT(smallest_sine(grains.triangle(t)), 0);
    }
}

/// Checks that the opposite angles of each free edge sum to at most 180 degrees.
void expect_delaunay(const GrainTriangulation& grains) {
    for (int h = 0; h < grains.n_halfedges(); ++h) {
        if (grains.edge(h) != Edge::kFree) continue;
        const int o = grains.opposite(h);
        ASSERT_LT(angle_at(grains.triangle(h / 3), GrainTriangulation::previous(h) % 3) +
                      angle_at(grains.triangle(o / 3), GrainTriangulation::previous(o) % 3),
                  180 + 1e-6);
    }
}

TEST(GrainTriangulation, CoversEveryLatticeForOneSiteAndMore) {
    for (const auto& [name, lattice] : testing::lattices()) {
        if (name == "huge") continue;
        for (const int n : {1, 2, 3, 20}) {
            SCOPED_TRACE(name + " n = " + std::to_string(n));
            const PeriodicMesh cells = random_cells(lattice, n, 3);
            const GrainTriangulation grains(cells);
            ASSERT_EQ(grains.n_triangles(), cells.n_corners() - 2 * cells.n_faces());
            expect_triangulation(grains);
            expect_delaunay(grains);
        }
    }
}

TEST(GrainTriangulation, SplitsBothSidesOfAnEdge) {
    for (const int n : {1, 2, 12}) {
        GrainTriangulation grains(random_cells(Lattice({1, 0}, {0.37, 0.81}), n, 4));
        for (int k = 0; k < 40; ++k) {
            int h = (7 * k) % grains.n_halfedges();
            while (grains.edge(h) != Edge::kCell) h = (h + 1) % grains.n_halfedges();
            const int before = grains.n_triangles();
            grains.split_edge(h, 0.3);
            ASSERT_EQ(grains.n_triangles(), before + 2);
            expect_triangulation(grains);
            expect_delaunay(grains);
            if (HasFatalFailure()) return;
        }
    }
}

TEST(GrainTriangulation, StaysDelaunayWhileVerticesAreInsertedAndMoved) {
    GrainTriangulation grains(random_cells(Lattice::rectangle(1, 1), 5, 5));
    for (int k = 0; k < 60; ++k) {
        const int t = (11 * k) % grains.n_triangles();
        const auto [p, q, r] = grains.triangle(t);
        grains.insert(t, 0.4 * p + 0.35 * q + 0.25 * r);
        expect_triangulation(grains);
        expect_delaunay(grains);
        if (HasFatalFailure()) return;
    }
    const auto narrowest = [&grains] {
        double sine = 1;
        for (int t = 0; t < grains.n_triangles(); ++t) {
            sine = std::min(sine, smallest_sine(grains.triangle(t)));
        }
        return sine;
    };
    const double before = narrowest();
    widen_angles(grains, 30);
    expect_triangulation(grains);
    expect_delaunay(grains);
    EXPECT_GT(narrowest(), before);
}

// A guard has two equal sides, and both faces at an edge share its vertices.
TEST(CornerGuards, HaveEqualSidesAtEverySharpCorner) {
    const PeriodicMesh cells = random_cells(Lattice::rectangle(1, 1), 200, 6);
    const GuardedCells guarded = guard_corners(cells, {0.05});
    ASSERT_GT(guarded.tip.size(), 20U);
    const PeriodicMesh& mesh = guarded.cells;
    ASSERT_EQ(mesh.n_vertices() - mesh.n_corners() / 2 + mesh.n_faces(), 0);
    std::vector<bool> is_tip(static_cast<std::size_t>(mesh.n_corners()), false);
    for (const int tip : guarded.tip) is_tip[static_cast<std::size_t>(tip)] = true;
    int before = 0;
    for (int c = 0; c < mesh.n_corners(); ++c) {
        before = c == mesh.face_begin[mesh.corner_face[c]]
                     ? mesh.face_begin[mesh.corner_face[c] + 1] - 1
                     : c - 1;
        const std::array<Vec2, 3> ear{mesh.point(c), mesh.point(mesh.next(c)), mesh.point(before)};
        const double angle = angle_at(ear, 0);
        EXPECT_EQ(is_tip[static_cast<std::size_t>(c)], angle > 0 && angle < kSharpCorner);
        if (!is_tip[static_cast<std::size_t>(c)]) continue;
        EXPECT_NEAR((ear[1] - ear[0]).norm(), (ear[2] - ear[0]).norm(), 1e-14);
    }
}

}  // namespace
}  // namespace pcvt::plane
