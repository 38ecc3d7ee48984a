#include "mesher/space/mesh/polyhedral_mesh.hpp"

#include <gtest/gtest.h>

#include "mesher/space/mesh/cell_faces.hpp"
#include "mesher/space/mesh/polyhedral_assembly.hpp"
#include "mesher/space/proof/polyhedral_proof.hpp"
#include "tests/support/polyhedra.hpp"

namespace pcvt::space {
namespace {

using testing::mesh_of;
using testing::space_cases;
using testing::SpaceCase;

TEST(PolyhedralMesh, IsProved) {
    for (const SpaceCase& c : space_cases()) {
        SCOPED_TRACE(c.name);
        const PolyhedralMesh mesh = mesh_of(c);
        const PolyhedralProof proof = prove_polyhedra(mesh);
        EXPECT_EQ(proof.n_cells, c.points.cols());
        EXPECT_NEAR(proof.volume / c.lattice.volume(), 1, 1e-12);
    }
}

/// Corners of four cells never pinch the boundary.
TEST(PolyhedralMesh, OfSitesInGeneralPositionHasAManifoldBoundary) {
    for (const SpaceCase& c : space_cases()) {
        if (c.name.starts_with("lattice") || c.name.starts_with("grid")) continue;
        EXPECT_TRUE(prove_polyhedra(mesh_of(c)).boundary_is_manifold) << c.name;
    }
}

TEST(PolyhedralMesh, LiesRoundTheDomainAtTheOrigin) {
    const Lattice box = Lattice::box(2, 1, 1);
    const SpaceCase c{"box", box, uniform_points(box, 200, 7)};
    for (const CellBody& body : cell_bodies(mesh_of(c))) {
        const Vec3 u = box.to_lattice(body.centroid);
        EXPECT_GT(u.minCoeff(), -1e-6);
        EXPECT_LT(u.maxCoeff(), 1 + 1e-6);
    }
}

/// A grid fills the box itself: three translations and eight corners of one orbit.
TEST(PolyhedralMesh, OfAGridIsABox) {
    for (const int k : {1, 2, 3, 4}) {
        const SpaceCase c{"", Lattice::box(1, 1, 1), testing::grid_points(k)};
        const PolyhedralMesh mesh = mesh_of(c);
        const PolyhedralProof proof = prove_polyhedra(mesh);
        EXPECT_EQ(proof.n_translations, 3);
        EXPECT_EQ(proof.n_boundary_pairs, 3 * k * k);
        EXPECT_EQ(mesh.n_points(), (k + 1) * (k + 1) * (k + 1));
        EXPECT_TRUE(proof.boundary_is_manifold);
    }
}

/// The law of assembled_mesh().
TEST(AssembledMesh, IsTheMeshOfTheListedCells) {
    for (const SpaceCase& c : space_cases()) {
        SCOPED_TRACE(c.name);
        const PolyhedralMesh mesh = mesh_of(c);
        const PolyhedralMesh again = assembled_mesh(mesh.lattice, polyhedron_list(mesh));
        EXPECT_EQ(again.points, mesh.points);
        EXPECT_EQ(again.owner, mesh.owner);
        EXPECT_EQ(again.neighbour, mesh.neighbour);
        EXPECT_EQ(again.point_orbit, mesh.point_orbit);
        EXPECT_EQ(again.point_offset, mesh.point_offset);
        ASSERT_EQ(again.patches.size(), mesh.patches.size());
        for (std::size_t p = 0; p < mesh.patches.size(); ++p) {
            EXPECT_EQ(again.patches[p].offset, mesh.patches[p].offset);
            EXPECT_EQ(again.patches[p].n_faces, mesh.patches[p].n_faces);
        }
        prove_polyhedra(again);
    }
}

}  // namespace
}  // namespace pcvt::space
