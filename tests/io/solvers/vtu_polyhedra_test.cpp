#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/solvers/vtu_volumes.hpp"
#include "io/solvers/vtu_writer.hpp"
#include "mesher/base/error.hpp"
#include "mesher/cells/orientations.hpp"
#include "mesher/plane/proof/validate.hpp"
#include "tests/support/damaged_text.hpp"
#include "tests/support/space_tiles.hpp"

namespace pcvt {
namespace {

using ::testing::HasSubstr;

EncodedFile encoded_polyhedra(const SpaceTile& tile) {
    return encode_vtu(vtu_grid(tile), "t.vtu").front();
}

/// The message of the reader for a file of random cells with one exchanged piece.
std::string polyhedra_fault(const std::string& piece, const std::string& other) {
    EncodedFile file = encoded_polyhedra(testing::random_space_tile(6));
    file.bytes = testing::exchanged(file.bytes, piece, other);
    return testing::fault_in([&] { decode_vtu_polyhedra(file); });
}

TEST(VtuPolyhedra, GivesBackPointsCellsPairsAndSites) {
    for (const testing::SpaceCase& c : testing::space_cases()) {
        SCOPED_TRACE(c.name);
        const SpaceTile tile = testing::tile_of(c);
        const SpaceTile found = decode_vtu_polyhedra(encoded_polyhedra(tile));
        EXPECT_EQ(found.mesh.points, tile.mesh.points);
        EXPECT_EQ(found.mesh.point_orbit, tile.mesh.point_orbit);
        EXPECT_EQ(found.mesh.point_offset, tile.mesh.point_offset);
        EXPECT_EQ(found.mesh.owner.size(), tile.mesh.owner.size());
        EXPECT_EQ(found.mesh.neighbour, tile.mesh.neighbour);
        EXPECT_EQ(found.sites, tile.sites);
    }
}

SpaceTile tile_with_materials() {
    SpaceTile tile = testing::random_space_tile(6);
    tile.materials = {.phase_names = {"a", "b"},
                      .site_phase = {0, 1, 1, 0, 1, 0},
                      .site_orientation = random_orientations(6, 1)};
    return tile;
}

TEST(VtuPolyhedra, GivesBackPhasesAndOrientations) {
    const SpaceTile tile = tile_with_materials();
    EXPECT_EQ(prove_space_files({encoded_polyhedra(tile)}).tile.materials, tile.materials);
    EXPECT_NO_THROW(prove_own_space_files({encoded_polyhedra(tile)}, tile));
    SpaceTile other = tile;
    other.materials.site_phase[2] = 0;
    EXPECT_THROW(prove_own_space_files({encoded_polyhedra(other)}, tile), InternalError);
    other = tile;
    other.materials.site_orientation[3].Phi += 1e-9;
    EXPECT_THROW(prove_own_space_files({encoded_polyhedra(other)}, tile), InternalError);
}

TEST(VtuPolyhedra, NamesLinesOfWrongMaterials) {
    EncodedFile file = encoded_polyhedra(tile_with_materials());
    file.bytes = testing::exchanged(file.bytes, "\n0\n1\n1\n0\n1\n0\n", "\n0\n1\n2\n0\n1\n0\n");
    EXPECT_THAT(testing::fault_in([&] { decode_vtu_polyhedra(file); }),
                HasSubstr("a site has a phase without a name"));
}

TEST(VtuPolyhedra, IsProvedFromItsBytes) {
    for (const testing::SpaceCase& c : testing::space_cases()) {
        SCOPED_TRACE(c.name);
        const std::vector<EncodedFile> files = encode_vtu(vtu_grid(testing::tile_of(c)), "t.vtu");
        ASSERT_EQ(space_file_kind(files), SpaceFileKind::kPolyhedra);
        const SpaceFileProof proof = prove_space_files(files);
        EXPECT_EQ(proof.proof.n_cells, c.points.cols());
        ASSERT_TRUE(proof.sites);
        EXPECT_LT(proof.sites->from_bisector, 1e-8);
    }
}

TEST(VtuPolyhedra, StatesTheLengthOfRemovedEdges) {
    for (const testing::SpaceCase& c : testing::space_cases()) {
        SCOPED_TRACE(c.name);
        const SpaceTile tile = testing::tile_of(c, 0.05);
        EncodedFile file = encoded_polyhedra(tile);
        const SpaceTile found = prove_space_files({file}).tile;
        EXPECT_EQ(found.mesh.short_edges, 0.05);
        EXPECT_EQ(found.mesh.points, tile.mesh.points);
        if (c.points.cols() != 200) continue;
        file.bytes = testing::exchanged(file.bytes, "\"ShortEdges\"", "\"OtherEdges\"");
        EXPECT_THROW(prove_space_files({file}), BadFile);
    }
}

TEST(VtuPolyhedra, HasTheSameBytesOnEachRun) {
    const SpaceTile tile = testing::random_space_tile(20);
    EXPECT_EQ(encoded_polyhedra(tile).bytes, encoded_polyhedra(tile).bytes);
}

TEST(VtuPolyhedra, IsProvedWithoutTheArraysOfPcvt) {
    EncodedFile file = encoded_polyhedra(testing::random_space_tile(6));
    file.bytes = testing::exchanged(file.bytes, "written by pcvt", "of another program");
    for (const char* name : {"Site", "Volume", "Faces", "CellId", "PeriodicPointIds"}) {
        const std::string quoted = "Name=\"" + std::string(name) + "\"";
        file.bytes = testing::exchanged(file.bytes, quoted, "Name=\"another\"");
    }
    const SpaceFileProof proof = prove_space_files({file});
    EXPECT_EQ(proof.proof.n_cells, 6);
    EXPECT_FALSE(proof.sites);
}

TEST(VtuPolyhedra, RefusesFilesThatAreDamaged) {
    EXPECT_THAT(polyhedra_fault("PeriodicLattice", "Lattice"), HasSubstr("lacks the array"));
    EXPECT_THAT(
        polyhedra_fault("type=\"Float64\" Name=\"Points\"", "type=\"Float32\" Name=\"Points\""),
        HasSubstr("too coarse"));
    EXPECT_THAT(polyhedra_fault("Name=\"types\" format=\"ascii\">\n42", "Name=\"types\">\n12"),
                HasSubstr("the cells are not all polyhedra (42); "));
    EXPECT_THAT(polyhedra_fault("Name=\"CellId\" format=\"ascii\">\n0", "Name=\"CellId\">\n1"),
                HasSubstr("not that of its site"));
    EXPECT_THAT(polyhedra_fault("Name=\"Faces\" format=\"ascii\">\n", "Name=\"Faces\">\n1"),
                HasSubstr("faces"));
    EXPECT_THAT(polyhedra_fault("Name=\"Volume\" format=\"ascii\">\n", "Name=\"Volume\">\n1"),
                HasSubstr("another volume"));
    EXPECT_THAT(polyhedra_fault("Name=\"PeriodicPointIds\" format=\"ascii\">\n0",
                                "Name=\"PeriodicPointIds\">\n1"),
                HasSubstr("point 0 is point 0 moved by (0, 0, 0)"));
    EXPECT_THAT(polyhedra_fault("Name=\"offsets\" format=\"ascii\">\n", "Name=\"offsets\">\n1"),
                HasSubstr("the offsets do not rise"));
    EXPECT_THAT(
        polyhedra_fault("Name=\"connectivity\" format=\"ascii\">\n", "Name=\"connectivity\">\n1"),
        HasSubstr("cell 0 has other points than its faces"));
    EXPECT_THAT(
        polyhedra_fault("Name=\"faceoffsets\" format=\"ascii\">\n", "Name=\"faceoffsets\">\n1"),
        HasSubstr("another number"));
    EXPECT_THAT(polyhedra_fault("Name=\"faces\" format=\"ascii\">\n", "Name=\"faces\">\n-"),
                HasSubstr("not a number from"));
}

TEST(VtuPolyhedra, RefutesAMovedPoint) {
    EncodedFile file = encoded_polyhedra(testing::random_space_tile(6));
    file.bytes = testing::exchanged(file.bytes, "Name=\"Volume\"", "Name=\"another\"");
    const std::string head = "Name=\"Points\" NumberOfComponents=\"3\" format=\"ascii\">\n";
    const auto begin = file.bytes.find(head) + head.size();
    file.bytes.replace(begin, file.bytes.find(' ', begin) - begin, "0.1234");
    EXPECT_THROW(prove_space_files({file}), NotATile);
}

TEST(VtuPolyhedra, RefutesAMovedSite) {
    SpaceTile tile = testing::random_space_tile(6);
    tile.sites(1, 2) += 1e-6;
    EXPECT_THROW(prove_space_files(encode_vtu(vtu_grid(tile), "t.vtu")), NotATile);
}

}  // namespace
}  // namespace pcvt
