#include "mesher/plane/tile/tile_builder.hpp"

#include <gtest/gtest.h>

#include <random>

#include "mesher/plane/mesh/outline.hpp"
#include "mesher/plane/mesh/valence.hpp"
#include "mesher/plane/mesh/voronoi.hpp"
#include "mesher/plane/proof/validate.hpp"
#include "mesher/plane/tile/tile_valence.hpp"
#include "tests/support/lattices.hpp"
#include "tests/support/special_sites.hpp"

namespace pcvt::plane {
namespace {

using testing::lattices;
using testing::random_lattice;

Tile tile_of(const PeriodicMesh& mesh, const Vec2& origin = {0, 0}) {
    return make_tile(mesh, whole_outline(mesh, origin));
}

/// Laws 1, 3 and 4, by the proof that `pcvt check` uses.
void expect_proof(const PeriodicMesh& mesh, const Vec2& origin = {0, 0}) {
    const Tile flat = tile_of(mesh, origin);
    const TileProof proof = prove_tile(flat, Precision::kDouble);
    compare_vertex_pairs(flat, proof);
    compare_edge_pairs(flat, proof);
    ASSERT_EQ(flat.n_faces(), mesh.n_faces());
    ASSERT_EQ(proof.n_orbits, mesh.n_vertices());
}

void expect_proofs(const Sites& sites, const Vec2& origin = {0, 0}) {
    const PeriodicDelaunay delaunay(sites);
    expect_proof(cell_mesh(delaunay), origin);
    expect_proof(triangle_mesh(delaunay), origin);
}

TEST(Tile, IsProvedFromOneSiteOnOnEveryLattice) {
    for (const auto& [name, lattice] : lattices()) {
        for (const int n : {1, 2, 3, 4, 5, 6, 7, 8, 30, 300}) {
            SCOPED_TRACE(name + " n = " + std::to_string(n));
            expect_proofs(Sites(lattice, uniform_points(lattice, n, 1)));
        }
    }
}

TEST(Tile, IsProvedWhereSitesAreCocircularOrOnTheSeam) {
    for (const auto& [name, sites] : testing::special_sites()) {
        SCOPED_TRACE(name);
        expect_proofs(sites);
    }
}

Sites sites_on_a_circle(int n) {
    Points points(2, n);
    for (int k = 0; k < n; ++k) {
        const double angle = 2 * M_PI * k / n;
        points.col(k) << 0.5 + 0.3 * std::cos(angle), 0.5 + 0.3 * std::sin(angle);
    }
    return {Lattice::rectangle(1, 1), points};
}

// Merging may spread one vertex over more than the smallest cells near it.
TEST(Tile, OfThousandsOfSitesOnACircleIsProvedOrRefused) {
    expect_proofs(sites_on_a_circle(300));
    for (const int n : {2900, 3000, 5000}) {
        try {
            expect_proofs(sites_on_a_circle(n));
        } catch (const NotATile& error) {
            FAIL() << n << ": " << error.what();
        } catch (const InvalidInput&) {
        }
    }
}

// "Faces whose centre lies in the domain" is not a disc in 4 to 10 % of such cases.
TEST(Tile, IsADiscForRandomSmallInputs) {
    std::mt19937_64 random(5);
    for (int k = 0; k < 1500; ++k) {
        const Lattice lattice = random_lattice(random);
        const Points points = uniform_points(lattice, 1 + k % 15, random());
        SCOPED_TRACE("input " + std::to_string(k));
        expect_proofs(Sites(lattice, points), points.col(0) * (k % 3));
        if (HasFatalFailure()) return;
    }
}

TEST(Tile, IsProvedWhenRepeated) {
    for (const auto& [name, lattice] : lattices()) {
        for (const auto& [columns, rows] : {std::pair(2, 3), std::pair(4, 1), std::pair(1, 2)}) {
            SCOPED_TRACE(name);
            const PeriodicDelaunay delaunay(Sites(lattice, uniform_points(lattice, 5, 6)));
            const PeriodicMesh cells = repeated(cell_mesh(delaunay), columns, rows);
            ASSERT_EQ(cells.n_faces(), 5 * columns * rows);
            ASSERT_EQ(cells.site[7], 2);
            expect_proof(cells);
            expect_proof(repeated(triangle_mesh(delaunay), columns, rows));
        }
    }
}

TEST(Seam, PositionsAreRepresentativePlusTranslation) {
    const Lattice lattice({1, 0}, {0.37, 0.81});
    const PeriodicDelaunay delaunay(Sites(lattice, uniform_points(lattice, 20, 8)));
    const Tile flat = tile_of(cell_mesh(delaunay));
    ASSERT_FALSE(flat.vertex_pairs.empty());
    for (const VertexPair& pair : flat.vertex_pairs) {
        EXPECT_LT(pair.v, pair.w);
        const Vec2 expected = flat.points[pair.v] + lattice.translation(pair.offset);
        EXPECT_LT((flat.points[pair.w] - expected).cwiseAbs().maxCoeff(), 0x1p-51);
    }
}

TEST(Outline, StaysCompact) {
    const Lattice unit = Lattice::rectangle(1, 1);
    const PeriodicDelaunay delaunay(Sites(unit, uniform_points(unit, 1000, 9)));
    const Tile flat = tile_of(cell_mesh(delaunay), {-0.5, 0.25});
    for (const Vec2& p : flat.points) {
        EXPECT_GT((p - Vec2(-0.5, 0.25)).minCoeff(), -0.15);
        EXPECT_LT((p - Vec2(-0.5, 0.25)).maxCoeff(), 1.15);
    }
}

TEST(Tile, CellsHaveTheirSidesOnTheTorus) {
    for (const auto& [name, lattice] : lattices()) {
        const PeriodicMesh cells =
            cell_mesh(PeriodicDelaunay(Sites(lattice, uniform_points(lattice, 25, 11))));
        EXPECT_EQ(cell_sides(tile_of(cells)), cell_sides(cells)) << name;
    }
}

TEST(Tile, FacesAndVerticesKnowTheirSites) {
    const Lattice lattice({1, 0}, {7, 1});
    const PeriodicDelaunay delaunay(Sites(lattice, uniform_points(lattice, 12, 10)));
    const Tile cells = tile_of(cell_mesh(delaunay));
    const Tile moved = tile_of(cell_mesh(delaunay), {40, -30});
    for (int f = 0; f < cells.n_faces(); ++f) {
        EXPECT_EQ(cells.face_site[f], f);
        const Vec2 from_corner =
            cells.site_points[f] - cells.points[cells.faces.corners[cells.faces.begin[f]]];
        const Vec2 there =
            moved.site_points[f] - moved.points[moved.faces.corners[moved.faces.begin[f]]];
        EXPECT_LT(from_corner.norm(), 1);
        EXPECT_LT((there - from_corner).norm(), 1e-13);
    }
    const Tile triangles = tile_of(triangle_mesh(delaunay));
    for (int v = 0; v < triangles.n_vertices(); ++v) {
        const Vec2 d = triangles.points[v] - delaunay.sites().position(triangles.vertex_site[v]);
        const Vec2 u = lattice.to_lattice(d);
        EXPECT_LT((u - u.array().round().matrix()).norm(), 1e-13);
    }
}

}  // namespace
}  // namespace pcvt::plane
