#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/space/space_foam_reader.hpp"
#include "io/space/space_foam_writer.hpp"
#include "mesher/plane/proof/validate.hpp"
#include "tests/support/damaged_text.hpp"
#include "tests/support/space_tiles.hpp"

namespace pcvt {
namespace {

using ::testing::HasSubstr;

/// The message of the reader for a case of random cells with one exchanged piece.
std::string foam_fault(const std::string& name, const std::string& piece,
                       const std::string& other) {
    const auto files = encode_space_foam(testing::random_space_tile(6), "t.foam");
    return testing::fault_in(
        [&] { prove_space_files(testing::exchanged(files, name, piece, other)); });
}

TEST(SpaceFoam, GivesBackTheMesh) {
    for (const testing::SpaceCase& c : testing::space_cases()) {
        SCOPED_TRACE(c.name);
        const SpaceTile tile = testing::tile_of(c);
        const std::vector<EncodedFile> files = encode_space_foam(tile, "t.foam");
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

TEST(SpaceFoam, StatesTheLengthOfRemovedEdges) {
    const space::Lattice cube = space::Lattice::box(1, 1, 1);
    const SpaceTile tile = testing::tile_of({"", cube, uniform_points(cube, 200, 2)}, 0.05);
    const std::vector<EncodedFile> files = encode_space_foam(tile, "t.foam");
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

TEST(SpaceFoam, NamesItsFilesInTheirOrder) {
    const auto files = encode_space_foam(testing::random_space_tile(6), "a/t.foam");
    const std::vector<std::string> paths = space_foam_paths("a/t.foam");
    ASSERT_EQ(files.size(), paths.size());
    for (std::size_t k = 0; k < files.size(); ++k) EXPECT_EQ(files[k].path, paths[k]);
    EXPECT_EQ(paths.back(), "a/t.foam/t.foam");
}

TEST(SpaceFoam, RefusesNumbersThatReferToNothing) {
    EXPECT_THAT(foam_fault("faces", "(0 ", "(99999 "), HasSubstr("unknown point"));
    EXPECT_THAT(foam_fault("owner", "\n(\n0\n", "\n(\n-1\n"), HasSubstr("too few faces"));
    EXPECT_THAT(foam_fault("owner", "\n(\n0\n", "\n(\n99999\n"), HasSubstr("too few faces"));
}

TEST(SpaceFoam, RefusesPatchesThatAreNoSeam) {
    EXPECT_THAT(foam_fault("boundary", "type            cyclic", "type            wall"),
                HasSubstr("one side of a seam"));
    EXPECT_THAT(foam_fault("boundary", "    seam_", "    side_"), HasSubstr("one side of a seam"));
    EXPECT_THAT(foam_fault("boundary", "neighbourPatch  seam_", "neighbourPatch  side_"),
                HasSubstr("there is no patch"));
    EXPECT_THAT(foam_fault("boundary", "startFace       ", "startFace       1"),
                HasSubstr("their order"));
    EXPECT_THAT(foam_fault("boundary", "// pcvt lattice", "// lattice"),
                HasSubstr("not one lattice"));
}

TEST(SpaceFoam, ComparesTheCaseWithItsMesh) {
    EXPECT_THAT(foam_fault("0/U", "type cyclic", "type empty"), HasSubstr("0/U"));
    EXPECT_THAT(foam_fault("boundary", "separationVector (", "separationVector (1"),
                HasSubstr("boundary"));
    EXPECT_THAT(foam_fault("boundary", "translational", "rotational"), HasSubstr("boundary"));
    EXPECT_THAT(foam_fault("system/controlDict", "icoFoam", "pisoFoam"), HasSubstr("controlDict"));
}

TEST(SpaceFoam, RefutesAMovedPoint) {
    const auto files = encode_space_foam(testing::random_space_tile(6), "t.foam");
    EXPECT_THROW(prove_space_files(testing::exchanged(files, "points", "\n(\n(", "\n(\n(1")),
                 NotATile);
}

}  // namespace
}  // namespace pcvt
