#include "mesher/space/proof/surface_proof.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mesher/plane/proof/validate.hpp"
#include "mesher/space/mesh/boundary_surface.hpp"
#include "mesher/space/mesh/cell_sites.hpp"
#include "tests/support/polyhedra.hpp"

namespace pcvt::space {
namespace {

using ::testing::HasSubstr;

TileSurface surface_of(const testing::SpaceCase& c) {
    const PolyhedralMesh mesh = testing::mesh_of(c);
    return tile_surface(mesh, sites_in_cells(Sites(c.lattice, c.points), mesh));
}

TileSurface random_surface(int n = 12) {
    const Lattice oblique({1, 0.2, 0.1}, {-0.3, 0.9, 0.2}, {0.4, 0.3, 1.2});
    return surface_of({"random", oblique, uniform_points(oblique, n, 3)});
}

/// The message of the proof; empty if it finds no fault.
std::string violation(const TileSurface& surface) {
    try {
        prove_surface(surface);
    } catch (const NotATile& fault) {
        return fault.what();
    }
    return "";
}

TEST(TileSurface, IsProvedWhereTheBoundaryIsAManifold) {
    int n_manifolds = 0;
    for (const testing::SpaceCase& c : testing::space_cases()) {
        SCOPED_TRACE(c.name);
        const PolyhedralMesh mesh = testing::mesh_of(c);
        const TileSurface surface = surface_of(c);
        EXPECT_EQ(surface.n_faces(), mesh.n_faces() - mesh.n_inner_faces());
        if (!boundary_is_manifold(mesh)) {
            EXPECT_THAT(violation(surface), HasSubstr("manifold"));
            continue;
        }
        ++n_manifolds;
        const SurfaceProof proof = prove_surface(surface);
        EXPECT_NEAR(proof.volume, c.lattice.volume(), 1e-12 * c.lattice.volume());
        EXPECT_EQ(2 * proof.n_translations, static_cast<int>(mesh.patches.size()));
        EXPECT_EQ(proof.n_parts, 1);
        EXPECT_EQ(proof.euler % 2, 0);
    }
    EXPECT_GT(n_manifolds, 40);
}

TEST(TileSurface, OfOneCellIsTheCell) {
    const Lattice cube = Lattice::box(1, 1, 1);
    const TileSurface surface = surface_of({"one", cube, Points::Zero(3, 1)});
    const SurfaceProof proof = prove_surface(surface);
    EXPECT_EQ(proof.n_points, 8);
    EXPECT_EQ(proof.n_faces, 6);
    EXPECT_EQ(proof.euler, 2);
    EXPECT_EQ(proof.n_translations, 3);
}

TEST(SurfaceProof, RefutesAMovedPoint) {
    TileSurface surface = random_surface();
    surface.points[5].x() += 1e-12;
    EXPECT_THAT(violation(surface), HasSubstr("is not its partner"));
    surface.points[5].x() = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THAT(violation(surface), HasSubstr("not finite"));
}

TEST(SurfaceProof, RefutesAPointWithoutAFace) {
    TileSurface surface = random_surface();
    surface.points.emplace_back(0, 0, 0);
    EXPECT_THAT(violation(surface), HasSubstr("no face has point"));
}

TEST(SurfaceProof, RefutesAFaceWithACornerTwice) {
    TileSurface surface = random_surface();
    surface.faces.corners[1] = surface.faces.corners[0];
    EXPECT_THAT(violation(surface), HasSubstr("three distinct corners"));
}

TEST(SurfaceProof, RefutesAMissingOrReversedFace) {
    TileSurface surface = random_surface();
    surface.faces.corners.resize(static_cast<std::size_t>(surface.faces.begin.end()[-2]));
    surface.faces.begin.pop_back();
    EXPECT_THAT(violation(surface), HasSubstr("two faces in opposite directions"));
    surface = random_surface();
    std::reverse(surface.faces.corners.begin(),
                 surface.faces.corners.begin() + surface.faces.size(0));
    EXPECT_THAT(violation(surface), HasSubstr("two faces in opposite directions"));
}

TEST(SurfaceProof, RefutesPartsThatTouchAtAPoint) {
    // Two tetrahedra with a common corner: every edge has two faces.
    TileSurface surface{.lattice = Lattice::box(1, 1, 1)};
    surface.points = {{0, 0, 0},  {1, 0, 0},  {0, 1, 0}, {0, 0, 1},
                      {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}};
    for (const std::array<int, 4>& t : {std::array{0, 1, 2, 3}, std::array{0, 5, 4, 6}}) {
        surface.faces.add(std::array{t[0], t[2], t[1]});
        surface.faces.add(std::array{t[0], t[1], t[3]});
        surface.faces.add(std::array{t[0], t[3], t[2]});
        surface.faces.add(std::array{t[1], t[2], t[3]});
    }
    surface.partner.resize(8);
    surface.offset.resize(8);
    EXPECT_THAT(violation(surface), HasSubstr("more than one fan"));
}

TEST(SurfaceProof, RefutesOtherPartnersAndOffsets) {
    TileSurface surface = random_surface();
    const int partner = surface.partner[0];
    surface.partner[0] = surface.partner[1];
    EXPECT_THAT(violation(surface), HasSubstr("has another partner"));
    surface.partner[0] = surface.n_faces();
    EXPECT_THAT(violation(surface), HasSubstr("has another partner"));
    surface = random_surface();
    surface.offset[0].i += 1;
    EXPECT_THAT(violation(surface), HasSubstr("has another partner"));
    surface.offset[partner].i -= 1;
    EXPECT_THAT(violation(surface), HasSubstr("is not its partner"));
}

TEST(SurfaceProof, RefutesOtherCellsAndSites) {
    const TileSurface surface = random_surface();
    TileSurface damaged = surface;
    damaged.cell[3] = (surface.cell[3] + 1) % 12;
    EXPECT_THAT(violation(damaged), HasSubstr("not halfway between two sites"));
    for (const int cell : {-1, 12}) {
        damaged.cell[3] = cell;
        EXPECT_THAT(violation(damaged), HasSubstr("a cell without a site"));
    }
    damaged = surface;
    damaged.sites(2, surface.cell[3]) += 1e-6;
    EXPECT_THAT(violation(damaged), HasSubstr("not halfway between two sites"));
    damaged.sites.resize(3, 0);
    EXPECT_EQ(violation(damaged), "");
}

TEST(SurfaceProof, RefutesAnotherVolume) {
    // Two copies of a cube side by side enclose two domains of its lattice, and match it.
    TileSurface surface = surface_of(
        {"two", Lattice::box(2, 1, 1), (Points(3, 2) << 0.5, 1.5, 0, 0, 0, 0).finished()});
    EXPECT_EQ(violation(surface), "");
    surface.lattice = Lattice::box(1, 1, 1);
    for (Offset& offset : surface.offset) offset.i *= 2;
    EXPECT_THAT(violation(surface), HasSubstr("the volume"));
}

}  // namespace
}  // namespace pcvt::space
