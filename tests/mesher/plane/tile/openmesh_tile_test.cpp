#include "mesher/plane/tile/openmesh_tile.hpp"

#include <gmock/gmock.h>

#include <functional>

#include "mesher/base/error.hpp"
#include "mesher/plane/mesh/voronoi.hpp"
#include "mesher/plane/tile/build_tile.hpp"
#include "tests/support/grid_tile.hpp"
#include "tests/support/lattices.hpp"
#include "tests/support/power_tiles.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/tile_equality.hpp"

namespace pcvt::plane {
namespace {

using ::testing::HasSubstr;
using testing::lattices;

/// Every kind in every outline that it has.
std::vector<Tile> tiles_of(const PeriodicDelaunay& delaunay) {
    std::vector<Tile> tiles;
    for (const MeshKind kind : {MeshKind::kVoronoi, MeshKind::kDelaunay, MeshKind::kGrains}) {
        for (const Outline outline : {Outline::kWhole, Outline::kBox}) {
            if (kind == MeshKind::kDelaunay && outline == Outline::kBox) continue;
            tiles.push_back(build_tile(delaunay, {.kind = kind, .outline = outline}).tile);
        }
    }
    return tiles;
}

void expect_same_arrays(const Tile& tile) {
    const Tile back = pcvt::plane::tile(openmesh_tile(tile));
    testing::expect_same_tile(back, tile);
    EXPECT_EQ(back.site_points, tile.site_points);
    EXPECT_EQ(back.whole_sides, tile.whole_sides);
    EXPECT_EQ(back.order, tile.order);
}

TEST(OpenMeshTile, OfEveryKindAndOutlineGivesTheArraysBack) {
    for (const auto& [name, lattice] : lattices()) {
        for (const int n : {1, 2, 3, 4, 5, 6, 7, 8, 40}) {
            SCOPED_TRACE(name + " n = " + std::to_string(n));
            const PeriodicDelaunay delaunay(Sites(lattice, uniform_points(lattice, n, 7)));
            for (const Tile& tile : tiles_of(delaunay)) expect_same_arrays(tile);
        }
    }
}

TEST(OpenMeshTile, KeepsWeightsAndMetric) {
    for (const testing::CellShape& shape : testing::cell_shapes()) {
        for (const TileOptions& options : testing::tile_kinds()) {
            const Lattice lattice({1, 0}, {0.37, 0.81});
            const Tile tile = testing::power_tile(lattice, 9, 1, shape, options);
            expect_same_arrays(tile);
            const Tile back = pcvt::plane::tile(openmesh_tile(tile));
            EXPECT_EQ(back.site_weights, tile.site_weights);
            EXPECT_EQ(back.metric, tile.metric);
            EXPECT_EQ(tile.metric.is_round(), shape.metric.is_round());
            EXPECT_EQ(tile.site_weights.empty(), *shape.law == '\0');
        }
    }
}

TEST(OpenMeshTile, KeepsWhatFilesLeaveOut) {
    Tile cells = testing::grid_tile(Lattice::rectangle(1, 1), 3, 2);
    cells.edge_pairs = pcvt::plane::tile(openmesh_tile(cells)).edge_pairs;
    expect_same_arrays(cells);
    cells.site_points.clear();
    expect_same_arrays(cells);
    cells.face_site.clear();
    expect_same_arrays(cells);
    Tile grains =
        build_tile(PeriodicDelaunay(Sites(cells.lattice, uniform_points(cells.lattice, 3, 1))),
                   {.kind = MeshKind::kGrains, .order = 2, .repeat = {2, 1}})
            .tile;
    expect_same_arrays(grains);
}

// Laws 1 and 2.
template <class Mesh>
void expect_matched_boundary(const OpenMeshTileOf<Mesh>& tile) {
    const Mesh& mesh = tile.mesh;
    const OpenMeshProperties& id = tile.identification;
    int n_boundary = 0;
    for (const auto h : mesh.halfedges()) {
        const int partner = mesh.property(id.partner, h);
        ASSERT_EQ(partner >= 0, mesh.is_boundary(h));
        if (partner < 0) continue;
        ++n_boundary;
        const OpenMesh::HalfedgeHandle q(partner);
        ASSERT_NE(q, h);
        ASSERT_EQ(mesh.property(id.partner, q), h.idx());
        const auto offset = mesh.property(id.partner_offset, h);
        ASSERT_EQ(offset, -mesh.property(id.partner_offset, q));
        const Vec2 t = tile.lattice.translation({offset[0], offset[1]});
        const auto moved =
            mesh.point(mesh.from_vertex_handle(h)) + OpenMesh::Vec3d(t.x(), t.y(), 0);
        const double size = tile.lattice.a().norm() + tile.lattice.b().norm();
        ASSERT_LT((moved - mesh.point(mesh.to_vertex_handle(q))).norm(), 1e-14 * size);
    }
    ASSERT_EQ(n_boundary % 2, 0);
    ASSERT_GT(n_boundary, 0);
}

TEST(OpenMeshTile, PartnerOfPartnerIsItselfAndRunsTheOtherWay) {
    for (const auto& [name, lattice] : lattices()) {
        for (const int n : {1, 2, 3, 40}) {
            SCOPED_TRACE(name + " n = " + std::to_string(n));
            const PeriodicDelaunay delaunay(Sites(lattice, uniform_points(lattice, n, 7)));
            for (const Tile& tile : tiles_of(delaunay)) {
                std::visit([](const auto& any) { expect_matched_boundary(any); },
                           openmesh_tile(tile));
            }
        }
    }
}

std::string fault_of_arrays(const std::function<void(Tile&)>& damage) {
    Tile tile = testing::grid_tile(Lattice::rectangle(1, 1), 2, 2);
    damage(tile);
    return testing::refusal_of([&] { openmesh_tile(tile); });
}

TEST(OpenMeshTile, RefusesArraysThatItCannotHold) {
    EXPECT_EQ(fault_of_arrays([](Tile&) {}), "");
    EXPECT_THAT(fault_of_arrays([](Tile& t) { t.faces.corners[1] = 99; }),
                HasSubstr("vertex 99 does not exist"));
    EXPECT_THAT(fault_of_arrays([](Tile& t) { t.edge_pairs.pop_back(); }),
                HasSubstr("the pairs lack the boundary edge from "));
    EXPECT_THAT(fault_of_arrays([](Tile& t) { t.edge_pairs.push_back(t.edge_pairs[0]); }),
                HasSubstr("two pairs name the edge from "));
    EXPECT_THAT(fault_of_arrays([](Tile& t) { t.edge_pairs[0].v0 = 4; }),
                HasSubstr("which is not on the boundary"));
    EXPECT_THAT(fault_of_arrays([](Tile& t) { t.kind = MeshKind::kGrains; }),
                HasSubstr("face 0 has 4 corners"));
    EXPECT_THAT(fault_of_arrays([](Tile& t) { t.copies = {0}; }), HasSubstr("copies"));
    ::testing::internal::CaptureStderr();
    EXPECT_THAT(fault_of_arrays([](Tile& t) { t.faces.add(t.faces[0]); }),
                HasSubstr("face 4 and those before it form no surface"));
    ::testing::internal::GetCapturedStderr();
}

std::string fault_of_mesh(const std::function<void(CellTile&)>& damage) {
    OpenMeshTile any = openmesh_tile(testing::grid_tile(Lattice::rectangle(1, 1), 2, 2));
    damage(std::get<CellTile>(any));
    return testing::refusal_of([&] { pcvt::plane::tile(any); });
}

OpenMesh::HalfedgeHandle boundary_of(const CellTile& tile) {
    for (const auto h : tile.mesh.halfedges()) {
        if (tile.mesh.is_boundary(h)) return h;
    }
    return OpenMesh::HalfedgeHandle();
}

TEST(OpenMeshTile, RefusesPropertiesThatContradictEachOther) {
    EXPECT_EQ(fault_of_mesh([](CellTile&) {}), "");
    EXPECT_THAT(fault_of_mesh([](CellTile& t) {
                    t.mesh.property(t.identification.partner, boundary_of(t)) = -1;
                }),
                HasSubstr("which does not answer it"));
    EXPECT_THAT(fault_of_mesh([](CellTile& t) {
                    t.mesh.property(t.identification.partner_offset, boundary_of(t))[0] += 1;
                }),
                HasSubstr("which does not answer it"));
    EXPECT_THAT(fault_of_mesh([](CellTile& t) {
                    t.mesh.property(t.identification.orbit, OpenMesh::VertexHandle(8)) = 7;
                }),
                HasSubstr("vertex 8 has the orbit 7, which is not a representative"));
    EXPECT_THAT(fault_of_mesh([](CellTile& t) {
                    t.mesh.property(t.identification.face_site, OpenMesh::FaceHandle(1)) = -1;
                }),
                HasSubstr("only 3 of 4 faces have sites"));
    EXPECT_THAT(fault_of_mesh([](CellTile& t) { t.mesh.clean(); }), HasSubstr("it has no face"));
}

}  // namespace
}  // namespace pcvt::plane
