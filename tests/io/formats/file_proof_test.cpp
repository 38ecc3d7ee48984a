#include "io/formats/file_proof.hpp"

#include <gmock/gmock.h>

#include <algorithm>

#include "io/gltf/plane_gltf.hpp"
#include "mesher/base/error.hpp"
#include "mesher/plane/cvt/cvt.hpp"
#include "mesher/plane/mesh/outline.hpp"
#include "mesher/plane/mesh/voronoi.hpp"
#include "mesher/plane/proof/generated_tile.hpp"
#include "mesher/plane/tile/build_tile.hpp"
#include "mesher/plane/tile/site_positions.hpp"
#include "mesher/plane/tile/tile_builder.hpp"
#include "tests/support/damaged_text.hpp"
#include "tests/support/example_lattices.hpp"
#include "tests/support/grid_tile.hpp"

namespace pcvt {
namespace {

using ::testing::EndsWith;
using ::testing::HasSubstr;
using testing::kSquare;

plane::Tile cells(const plane::Lattice& lattice, int n) {
    const plane::CvtResult result = compute_cvt(lattice, uniform_points(lattice, n, 0), {});
    const plane::PeriodicMesh mesh = periodic_mesh(result.delaunay, plane::MeshKind::kVoronoi);
    return make_tile(mesh, whole_outline(mesh, plane::Vec2::Zero()));
}

const Format& glb() { return *find_format("t.glb"); }

std::string glb_refusal(const plane::Tile& tile, const plane::Vec2& origin) {
    try {
        prove_tile_files(glb(), encode_glb(tile, {}, "t.glb"), tile, origin);
    } catch (const InvalidInput& error) {
        return error.what();
    }
    return "";
}

TEST(FileProof, AFaithfulFileIsProved) {
    const plane::Tile tile = cells(plane::Lattice::rectangle(1, 1), 8);
    EXPECT_NO_THROW(verify_generated_tile(tile));
    EXPECT_NO_THROW(
        prove_tile_files(glb(), encode_glb(tile, {}, "t.glb"), tile, plane::Vec2::Zero()));
}

TEST(FileProof, ABrokenFileOfATileThatFitsIsAFaultOfPcvt) {
    const plane::Tile tile = cells(plane::Lattice::rectangle(1, 1), 8);
    plane::Tile moved = tile;
    moved.points[moved.vertex_pairs.at(0).w].x() += 1e-3;
    EXPECT_THROW(prove_tile_files(glb(), encode_glb(moved, {}, "t.glb"), tile, plane::Vec2::Zero()),
                 InternalError);
    plane::Tile unpaired = tile;
    unpaired.vertex_pairs.pop_back();
    EXPECT_THROW(
        prove_tile_files(glb(), encode_glb(unpaired, {}, "t.glb"), tile, plane::Vec2::Zero()),
        InternalError);
}

void prove_written(const std::string& path, const plane::Tile& written, const plane::Tile& proved) {
    const Format& format = *find_format(path);
    prove_tile_files(format, encode_tile(format, written, path), proved, plane::Vec2::Zero());
}

TEST(FileProof, AFileIsComparedInEveryNumberBeforeItsProofIsSkipped) {
    const plane::Tile tile = cells(plane::Lattice({1, 0}, {0.37, 0.81}), 9);
    plane::Tile moved = tile;
    moved.points[moved.vertex_pairs.at(0).w].x() += 1e-12;
    for (const char* path : {"t.obj", "t.ply", "t.vtu", "t.foam"}) {
        EXPECT_NO_THROW(prove_written(path, tile, tile)) << path;
        EXPECT_THROW(prove_written(path, moved, tile), InternalError) << path;
    }
    plane::Tile turned = tile;
    std::reverse(turned.faces.corners.begin(),
                 turned.faces.corners.begin() + turned.faces.begin[1]);
    for (const char* path : {"t.obj", "t.ply", "t.vtu"}) {
        EXPECT_THROW(prove_written(path, turned, tile), InternalError) << path;
    }
}

TEST(FileProof, StoredPairsAreComparedToo) {
    const plane::Tile tile = cells(plane::Lattice({1, 0}, {0.37, 0.81}), 9);
    plane::Tile unpaired = tile;
    unpaired.edge_pairs.pop_back();
    EXPECT_THROW(prove_written("t.obj", unpaired, tile), InternalError);
    unpaired = tile;
    unpaired.vertex_pairs.pop_back();
    for (const char* path : {"t.obj", "t.ply", "t.vtu"}) {
        EXPECT_THROW(prove_written(path, unpaired, tile), InternalError) << path;
    }
}

/// Sites nearly on one circle, of which two Voronoi vertices that no edge joins are closer than
/// 1e-9 h: to join them would pinch the cell between them.
plane::PeriodicDelaunay nearly_cocircular_sites() {
    plane::Points points(2, 6);
    points << 0.7059980078109676, 0.7774208217624856, 0.7972796284959138, 0.7973416347636813,
        0.7749882330486988, 0.7654095185644108, 0.2819063944314911, 0.3858173057792841,
        0.4596909133082334, 0.4601508807045719, 0.6199227739994844, 0.6398491598085132;
    return plane::PeriodicDelaunay(plane::Sites(plane::Lattice::rectangle(1, 1), points));
}

TEST(FileProof, VerticesThatNoEdgeJoinsStayTwoInTheMesh) {
    const plane::PeriodicDelaunay delaunay = nearly_cocircular_sites();
    const plane::PeriodicMesh mesh = cell_mesh(delaunay);
    double shortest = 1;
    double nearest = 1;
    for (int v = 0; v < mesh.n_vertices(); ++v) {
        for (int w = 0; w < v; ++w) {
            nearest = std::min(nearest, (mesh.vertices[v] - mesh.vertices[w]).norm());
        }
    }
    for (int c = 0; c < mesh.n_corners(); ++c) {
        shortest = std::min(shortest, (mesh.point(mesh.next(c)) - mesh.point(c)).norm());
    }
    const double h = delaunay.sites().spacing();
    EXPECT_LT(nearest, plane::kSameVertex * h);
    EXPECT_GE(shortest, plane::kSameVertex * h);
}

TEST(FileProof, NearlyCocircularSitesAreProvedInEveryFormat) {
    const plane::PeriodicDelaunay delaunay = nearly_cocircular_sites();
    for (const plane::MeshKind kind : {plane::MeshKind::kVoronoi, plane::MeshKind::kDelaunay}) {
        const plane::Tile tile = build_tile(delaunay, {.kind = kind}).tile;
        verify_generated_tile(tile);
        for (const Format& format : formats()) {
            if (!format.needs_tile() || !format.is_readable()) continue;
            if (!format.holds_polygons && kind == plane::MeshKind::kVoronoi) continue;
            const std::string path = "t" + std::string(format.extension);
            const TileFile file = decode_tile(format, encode_tile(format, tile, path), {});
            EXPECT_NO_THROW(prove_tile_file(file)) << path;
            EXPECT_NO_THROW(prove_written(path, tile, tile)) << path;
        }
    }
}

/// A tile with the positions of its sites.
plane::Tile placed_cells(const plane::Lattice& lattice, int n) {
    return build_tile(plane::PeriodicDelaunay(plane::Sites(lattice, uniform_points(lattice, n, 5))),
                      {})
        .tile;
}

TEST(FileProof, TwoExchangedSitesAreFoundInAFileWithTheirPositions) {
    const plane::Tile tile = placed_cells(plane::Lattice({1, 0}, {0.37, 0.81}), 9);
    for (const char* path : {"t.obj", "t.ply", "t.glb", "t.gltf", "t.om"}) {
        const Format& format = *find_format(path);
        TileFile file = decode_tile(format, encode_tile(format, tile, path), std::nullopt);
        EXPECT_EQ(file.tile.site_positions.size(), 9U) << path;
        EXPECT_NO_THROW(prove_tile_file(file)) << path;
        for (SiteId& site : file.tile.face_site) site = site == 4 ? 7 : site == 7 ? 4 : site;
        EXPECT_THROW(prove_tile_file(file), NotATile) << path;
    }
}

TEST(FileProof, AFileWithoutPositionsIsProvedToHaveAllSites) {
    const plane::Tile tile = cells(plane::Lattice({1, 0}, {0.37, 0.81}), 9);
    for (const char* path : {"t.obj", "t.ply", "t.glb", "t.gltf", "t.om"}) {
        const Format& format = *find_format(path);
        TileFile file = decode_tile(format, encode_tile(format, tile, path), std::nullopt);
        EXPECT_TRUE(file.tile.site_positions.empty()) << path;
        EXPECT_NO_THROW(prove_tile_file(file)) << path;
        for (SiteId& site : file.tile.face_site) site = site == 4 ? 7 : site;
        EXPECT_THROW(prove_tile_file(file), NotATile) << path;
    }
}

TEST(FileProof, TheSitesOfAFileAreThoseOfTheTileThatWasWritten) {
    const plane::Tile tile = placed_cells(plane::Lattice::rectangle(1, 1), 8);
    plane::Tile exchanged = tile;
    std::swap(exchanged.face_site[2], exchanged.face_site[5]);
    exchanged.site_positions = site_positions(tile);
    for (const char* path : {"t.obj", "t.ply", "t.glb"}) {
        EXPECT_NO_THROW(prove_written(path, tile, tile)) << path;
        EXPECT_THROW(prove_written(path, exchanged, tile), InternalError) << path;
    }
}

TEST(FileProof, ATileTooFineForFloatsIsRefusedWithTheAdviceThatHelps) {
    const plane::Tile thin = cells(plane::Lattice::rectangle(1, 1e-4), 1);
    EXPECT_NO_THROW(verify_generated_tile(thin));
    EXPECT_THAT(glb_refusal(thin, {0, 0}), EndsWith("take another format"));
    EXPECT_THAT(glb_refusal(thin, {1, 0}), EndsWith("or an origin nearer to 0,0"));
    EXPECT_THAT(glb_refusal(thin, {0, 0}), HasSubstr("t.glb: "));
}

TEST(FileProof, SitesMustReadBackAsTheyWere) {
    const Format& txt = *find_format("s.txt");
    const plane::Points sites = uniform_points(plane::Lattice::rectangle(1, 1), 4, 0);
    const auto files = std::get<SiteWriter*>(txt.write)(sites, "s.txt");
    EXPECT_NO_THROW(prove_site_files(txt, files, sites));
    plane::Points others = sites;
    others(0, 3) += 0x1p-40;
    EXPECT_THROW(prove_site_files(txt, files, others), InternalError);
}

/// Returns the refusal of the files of `tile` with `piece` replaced in the file that ends with
/// `name`.
std::string fault_with(const plane::Tile& tile, const std::string& path, const std::string& name,
                       const std::string& piece, const std::string& other) {
    const Format& format = *find_format(path);
    const std::vector<EncodedFile> files =
        testing::exchanged(encode_tile(format, tile, path), name, piece, other);
    return testing::fault_in(
        [&] { prove_file(format, files, decode_tile(format, files, std::nullopt)); });
}

TEST(FileProof, EntitiesAndGroupsOfGmshFollowFromTheTile) {
    const plane::Tile tile = testing::grain_grid_tile(kSquare, 2, 2);
    const auto fault = [&](const std::string& piece, const std::string& other) {
        return fault_with(tile, "t.msh", ".msh", piece, other);
    };
    EXPECT_EQ(fault("", ""), "");
    EXPECT_THAT(
        fault("\"seam_1_0\"", "\"seam_1_1\""),
        HasSubstr(": $PhysicalNames has '\"seam_1_1\"' where its tile has '\"seam_1_0\"'; "));
    EXPECT_THAT(fault("\n1 0 0 0 0.5 0 0 1 ", "\n1 0 0 0 0.6 0 0 1 "),
                HasSubstr(": $Entities has '0.6' where its tile has '0.5'; "));
    EXPECT_THAT(fault("$Periodic\n9\n0 3 1\n", "$Periodic\n9\n0 3 2\n"),
                HasSubstr(": $Periodic has '2' where its tile has '1'; "));
    EXPECT_THAT(fault("$Nodes\n9 9 1 9\n", "$Nodes\n9 9 1 8\n"),
                HasSubstr(": $Nodes has '8' where its tile has '9'; "));
}

TEST(FileProof, SetsOfAbaqusFollowFromTheTile) {
    const plane::Tile tile = testing::grain_grid_tile(kSquare, 2, 2);
    const auto fault = [&](const std::string& piece, const std::string& other) {
        return fault_with(tile, "t.inp", ".inp", piece, other);
    };
    EXPECT_THAT(fault("NSET=FIXED\n1\n", "NSET=FIXED\n2\n"),
                HasSubstr(": *NSET,NSET=FIXED has '2' where its tile has '1'; "));
    EXPECT_THAT(fault("NSET=seam_1_0", "NSET=seam_2_0"),
                HasSubstr("t.inp: lacks *NSET,NSET=SEAM_1_0; "));
    EXPECT_THAT(fault("NSET=seam_0_1\n1,2,3\n", "NSET=seam_0_1\n1,2\n"),
                HasSubstr(": *NSET,NSET=SEAM_0_1 ends where its tile has '3'; "));
    EXPECT_THAT(fault("*EQUATION", "*EQUATIONS"), HasSubstr("t.inp: lacks *EQUATION; "));
    EXPECT_THAT(fault("*NSET,NSET=FIXED", "*NSET,NSET=seam_9_9\n1\n*NSET,NSET=FIXED"),
                HasSubstr(": *NSET,NSET=SEAM_9_9 does not belong to its tile; "));
}

TEST(FileProof, SetsInAnotherOrderAndCardsOfAUserAreAccepted) {
    const plane::Tile tile = testing::grain_grid_tile(kSquare, 2, 2);
    const auto fault = [&](const std::string& piece, const std::string& other) {
        return fault_with(tile, "t.inp", ".inp", piece, other);
    };
    EXPECT_EQ(fault("NSET=seam_0_1\n1,2,3\n", "NSET=seam_0_1\n3,\n2,1,2\n"), "");
    EXPECT_EQ(
        fault("*EQUATION", "*NSET,NSET=LOADED\n3\n*MATERIAL,NAME=X\n*ELASTIC\n1,0.3\n*EQUATION"),
        "");
}

TEST(FileProof, ArraysOfVtkFollowFromTheTile) {
    const plane::Tile tile = testing::grid_tile(kSquare, 2, 2);
    const auto fault = [&](const std::string& piece, const std::string& other) {
        return fault_with(tile, "t.vtu", ".vtu", piece, other);
    };
    EXPECT_THAT(
        fault("\"GlobalIds\" format=\"ascii\">\n0\n1", "\"GlobalIds\" format=\"ascii\">\n0\n2"),
        HasSubstr(": PointData/GlobalIds has '2' where its tile has '1'; "));
    EXPECT_THAT(fault("NumberOfTuples=\"2\"", "NumberOfTuples=\"3\""),
                HasSubstr(": FieldData/PeriodicLattice has '3' where its tile has '2'; "));
    EXPECT_THAT(fault("Name=\"CellId\"", "Name=\"Cells\""), HasSubstr("lacks the sites; "));
    // VTK writes one value after the other, and arrays of its own.
    EXPECT_EQ(
        fault("\"GlobalIds\" format=\"ascii\">\n0\n1\n", "\"GlobalIds\" format=\"ascii\">\n 0 1 "),
        "");
}

TEST(FileProof, TheCaseOfAMeshIsComparedUntilItsNoteIsRemoved) {
    const plane::Tile tile = testing::grid_tile(kSquare, 3, 2);
    const auto fault = [&](const char* name, const std::string& piece, const std::string& other) {
        return fault_with(tile, "t.foam", name, piece, other);
    };
    EXPECT_EQ(fault("", "", ""), "");
    EXPECT_THAT(fault("0/U", "[0 1 -1 0 0 0 0]", "[0 1 -2 0 0 0 0]"), HasSubstr("t.foam/0/U:"));
    EXPECT_THAT(fault("system/controlDict", "icoFoam", "pisoFoam"),
                HasSubstr(": the file has 'pisoFoam' where its tile has 'icoFoam'; "));
    EXPECT_THAT(fault("polyMesh/boundary", "translational", "rotational"),
                HasSubstr(": the file has 'rotational' where its tile has 'translational'; "));
    const std::string note =
        "// pcvt check compares this file with its mesh; remove this line to change the file.\n";
    EXPECT_EQ(fault("system/controlDict", note + "application     icoFoam", "application pisoFoam"),
              "");
}

}  // namespace
}  // namespace pcvt
