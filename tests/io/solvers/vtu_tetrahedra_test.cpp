#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/solvers/vtu_writer.hpp"
#include "tests/support/damaged_text.hpp"
#include "tests/support/tetrahedra_files.hpp"

namespace pcvt {
namespace {

using ::testing::HasSubstr;

EncodedFile tetrahedra_vtu(const space::TetrahedralMesh& mesh) {
    return encode_vtu(vtu_grid(mesh), "t.vtu").front();
}

std::string tetrahedra_vtu_fault(const std::string& piece, const std::string& other) {
    EncodedFile file = tetrahedra_vtu(testing::random_tetrahedra(8));
    file.bytes = testing::exchanged(file.bytes, piece, other);
    return testing::fault_of_tetrahedra(file);
}

TEST(VtuTetrahedra, GivesBackPointsSitesAndTetrahedra) {
    const auto cases = testing::tetrahedra_cases();
    EXPECT_GT(cases.size(), 45U);
    for (const auto& [name, mesh] : cases) {
        SCOPED_TRACE(name);
        const EncodedFile file = tetrahedra_vtu(mesh);
        ASSERT_EQ(space_file_kind({file}), SpaceFileKind::kTetrahedra);
        EXPECT_NO_THROW(prove_own_tetrahedra({file}, mesh));
    }
}

TEST(VtuTetrahedra, InsideOfCellsAreGivenBackWithTheirCells) {
    const space::TetrahedralMesh mesh = testing::grain_tetrahedra(6);
    const EncodedFile file = tetrahedra_vtu(mesh);
    ASSERT_EQ(space_file_kind({file}), SpaceFileKind::kTetrahedra);
    EXPECT_NO_THROW(prove_own_tetrahedra({file}, mesh));
    EXPECT_EQ(prove_tetrahedral_files({file}).tile.mesh.cell, mesh.cell);
    EncodedFile damaged = file;
    damaged.bytes = testing::exchanged(file.bytes, "\n0\n1\n", "\n1\n1\n");
    EXPECT_THAT(testing::fault_of_tetrahedra(damaged), HasSubstr("t.vtu:"));
}

TEST(VtuTetrahedra, OfAnotherProgramIsProvedWithoutItsWords) {
    EncodedFile file = tetrahedra_vtu(testing::random_tetrahedra(8));
    file.bytes = testing::exchanged(file.bytes, std::string(kTetrahedraVtuMark), "");
    file.bytes = testing::exchanged(file.bytes, "Int32\" Name=\"CellId", "Int64\" Name=\"CellId");
    EXPECT_EQ(testing::fault_of_tetrahedra(file), "");
    file.bytes = testing::exchanged(file.bytes, "Name=\"CellId\"", "Name=\"Cell\"");
    EXPECT_THAT(testing::fault_of_tetrahedra(file), HasSubstr("CellId"));
}

TEST(VtuTetrahedra, IsRefusedWhereItStatesSomethingElse) {
    EXPECT_EQ(tetrahedra_vtu_fault("<Cells>", "<Cells>"), "");
    EXPECT_THAT(tetrahedra_vtu_fault("Float64\" Name=\"Points", "Float32\" Name=\"Points"),
                HasSubstr("too coarse for a proof"));
    EXPECT_THAT(tetrahedra_vtu_fault("<PointData>", "<PointData >"),
                HasSubstr("another line follows"));
    EXPECT_THAT(
        tetrahedra_vtu_fault("\n10\n10\n", "\n14\n10\n"),
        HasSubstr("the cells are not all tetrahedra (10) or all quadratic tetrahedra (24); "));
    EXPECT_THAT(tetrahedra_vtu_fault("\n4\n8\n", "\n3\n8\n"),
                HasSubstr("a tetrahedron here has 4 points, not 3; "));
    EXPECT_THAT(tetrahedra_vtu_fault("Name=\"PeriodicPointIds\" format=\"ascii\">\n0\n",
                                     "Name=\"PeriodicPointIds\" format=\"ascii\">\n3\n"),
                HasSubstr("point 0 is point 0 moved by (0, 0, 0)"));
    EXPECT_THAT(tetrahedra_vtu_fault("NumberOfPoints=\"", "NumberOfPoints=\"1"),
                HasSubstr("t.vtu"));
    EXPECT_THAT(tetrahedra_vtu_fault("1 0.2 0.1\n", "1.5 0.2 0.1\n"), HasSubstr("t.vtu"));
    EXPECT_THAT(tetrahedra_vtu_fault("1 0.2 0.1\n", "0 0 0\n"), HasSubstr("t.vtu:"));
}

TEST(VtuTetrahedra, RefutesOtherSitesAndTurnedTetrahedra) {
    space::TetrahedralMesh mesh = testing::random_tetrahedra(8);
    std::swap(mesh.tetrahedra[2][0], mesh.tetrahedra[2][1]);
    EXPECT_THAT(testing::fault_of_tetrahedra(tetrahedra_vtu(mesh)), HasSubstr("law (1)"));
    mesh = testing::random_tetrahedra(8);
    mesh.point_site[0] = (mesh.point_site[0] + 1) % 8;
    EXPECT_NE(testing::fault_of_tetrahedra(tetrahedra_vtu(mesh)), "");
    mesh = testing::random_tetrahedra(8);
    mesh.tetrahedra.pop_back();
    EXPECT_NE(testing::fault_of_tetrahedra(tetrahedra_vtu(mesh)), "");
}

}  // namespace
}  // namespace pcvt
