#include "io/openfoam/foam_polyhedra.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/openfoam/foam_writer.hpp"
#include "mesher/plane/proof/validate.hpp"
#include "tests/support/damaged_text.hpp"
#include "tests/support/space_tiles.hpp"

namespace pcvt {
namespace {

using ::testing::HasSubstr;

/// The message of the reader for a case of random cells with one exchanged piece.
std::string foam_fault(const std::string& name, const std::string& piece,
                       const std::string& other) {
    const auto files = encode_foam(foam_case(testing::random_space_tile(6)), "t.foam");
    return testing::fault_in(
        [&] { prove_space_files(testing::exchanged(files, name, piece, other)); });
}

TEST(FoamPolyhedra, GivesBackTheMesh) {
    for (const testing::SpaceCase& c : testing::space_cases()) {
        SCOPED_TRACE(c.name);
        const SpaceTile tile = testing::tile_of(c);
        const std::vector<EncodedFile> files = encode_foam(foam_case(tile), "t.foam");
        ASSERT_EQ(space_file_kind(files), SpaceFileKind::kPolyhedra);
        const SpaceTile found = prove_space_files(files).tile;
        EXPECT_EQ(found.mesh.points, tile.mesh.points);
        EXPECT_EQ(found.mesh.faces, tile.mesh.faces);
        EXPECT_EQ(found.mesh.owner, tile.mesh.owner);
        EXPECT_EQ(found.mesh.neighbour, tile.mesh.neighbour);
        EXPECT_EQ(found.mesh.point_orbit, tile.mesh.point_orbit);
        EXPECT_EQ(found.sites, tile.sites);
    }
}

TEST(FoamPolyhedra, StatesTheLengthOfRemovedEdges) {
    const space::Lattice cube = space::Lattice::box(1, 1, 1);
    const SpaceTile tile = testing::tile_of({"", cube, uniform_points(cube, 200, 2)}, 0.05);
    const std::vector<EncodedFile> files = encode_foam(foam_case(tile), "t.foam");
    EXPECT_EQ(prove_space_files(files).tile.mesh.short_edges, 0.05);
    const auto stating = [&](const std::string& words) {
        return testing::exchanged(files, "boundary", "// pcvt short_edges 0.05\n", words);
    };
    EXPECT_THROW(prove_space_files(stating("")), NotATile);
    for (const char* words : {"// pcvt short_edges 0.2\n", "// pcvt short_edges -1\n",
                              "// pcvt short_edges 0.05\n// pcvt short_edges 0.05\n"}) {
        EXPECT_THAT(testing::fault_in([&] { prove_space_files(stating(words)); }),
                    HasSubstr("not one number from 0 to 0.1"));
    }
}

TEST(FoamPolyhedra, NamesItsFilesInTheirOrder) {
    const auto files = encode_foam(foam_case(testing::random_space_tile(6)), "a/t.foam");
    const std::vector<std::string> paths = foam_paths("a/t.foam", FoamCells::kPolyhedra);
    ASSERT_EQ(files.size(), paths.size());
    for (std::size_t k = 0; k < files.size(); ++k) EXPECT_EQ(files[k].path, paths[k]);
    EXPECT_EQ(paths.back(), "a/t.foam/t.foam");
}

/// The message of a law that a damaged case breaks.
std::string broken_law(const std::string& name, const std::string& piece,
                       const std::string& other) {
    try {
        foam_fault(name, piece, other);
    } catch (const NotATile& fault) {
        return fault.what();
    }
    return "";
}

TEST(FoamPolyhedra, RefusesNumbersThatReferToNothing) {
    EXPECT_THAT(broken_law("faces", "(0 ", "(99999 "), HasSubstr("a face names point 99999"));
    EXPECT_THAT(broken_law("owner", "\n(\n0\n", "\n(\n-1\n"),
                HasSubstr("face 0 refers to a cell that does not exist"));
    EXPECT_THAT(broken_law("owner", "\n(\n0\n", "\n(\n2147483647\n"),
                HasSubstr("cell 2147483647 is named; there are only"));
    EXPECT_THAT(broken_law("neighbour", "\n(\n", "\n(\n9999"), HasSubstr("cell 9999"));
    EXPECT_THAT(foam_fault("boundary", "startFace       ", "startFace       1"),
                HasSubstr("; correct startFace and nFaces"));
}

TEST(FoamPolyhedra, RefusesPatchesThatAreNoSeam) {
    EXPECT_THAT(foam_fault("boundary", "type            cyclic", "type            wall"),
                HasSubstr("one side of a seam; name the cyclic ones seam_I_J_K"));
    EXPECT_THAT(foam_fault("boundary", "    seam_", "    side_"), HasSubstr("one side of a seam"));
    EXPECT_THAT(foam_fault("boundary", "neighbourPatch  seam_", "neighbourPatch  side_"),
                HasSubstr("there is no patch"));
    EXPECT_THAT(foam_fault("boundary", "// pcvt lattice", "// lattice"),
                HasSubstr("not one lattice"));
}

TEST(FoamPolyhedra, ComparesTheCaseWithItsMesh) {
    EXPECT_THAT(foam_fault("0/U", "type cyclic", "type empty"), HasSubstr("0/U"));
    EXPECT_THAT(foam_fault("boundary", "separationVector (", "separationVector (1"),
                HasSubstr("boundary"));
    EXPECT_THAT(foam_fault("boundary", "translational", "rotational"), HasSubstr("boundary"));
    EXPECT_THAT(foam_fault("system/controlDict", "icoFoam", "pisoFoam"), HasSubstr("controlDict"));
}

TEST(FoamPolyhedra, RefutesAMovedPoint) {
    const auto files = encode_foam(foam_case(testing::random_space_tile(6)), "t.foam");
    EXPECT_THROW(prove_space_files(testing::exchanged(files, "points", "\n(\n(", "\n(\n(1")),
                 NotATile);
}

}  // namespace
}  // namespace pcvt
