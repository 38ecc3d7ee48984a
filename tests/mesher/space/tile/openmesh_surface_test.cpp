#include "mesher/space/tile/openmesh_surface.hpp"

#include <gtest/gtest.h>

#include "mesher/space/mesh/boundary_surface.hpp"
#include "tests/support/polyhedra.hpp"

namespace pcvt::space {
namespace {

TEST(OpenMeshSurface, GivesBackTheArrays) {
    for (const testing::SpaceCase& c : testing::space_cases()) {
        const PolyhedralMesh mesh = testing::mesh_of(c);
        if (!boundary_is_manifold(mesh)) continue;
        SCOPED_TRACE(c.name);
        const TileSurface surface = tile_surface(mesh, c.points);
        const TileSurface found = tile_surface(openmesh_surface(surface));
        EXPECT_EQ(found.lattice.periods(), surface.lattice.periods());
        EXPECT_EQ(found.points, surface.points);
        EXPECT_EQ(found.faces.begin, surface.faces.begin);
        EXPECT_EQ(found.cell, surface.cell);
        EXPECT_EQ(found.partner, surface.partner);
        EXPECT_EQ(found.offset, surface.offset);
        EXPECT_EQ(found.sites, surface.sites);
    }
}

TEST(OpenMeshSurface, IsClosedAndItsFacesAreMatched) {
    const Lattice cube = Lattice::box(1, 1, 1);
    const TileSurface arrays =
        tile_surface(testing::mesh_of({"random", cube, uniform_points(cube, 20, 5)}), Points(3, 0));
    const OpenMeshSurface surface = openmesh_surface(arrays);
    for (const auto h : surface.mesh.halfedges()) EXPECT_FALSE(surface.mesh.is_boundary(h));
    for (const auto f : surface.mesh.faces()) {
        const OpenMesh::FaceHandle partner(surface.mesh.property(surface.partner, f));
        EXPECT_EQ(surface.mesh.property(surface.partner, partner), f.idx());
        EXPECT_EQ(surface.mesh.property(surface.offset, f),
                  -surface.mesh.property(surface.offset, partner));
        EXPECT_EQ(surface.mesh.valence(f), surface.mesh.valence(partner));
    }
}

}  // namespace
}  // namespace pcvt::space
