#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/space/tetrahedra_vtu_reader.hpp"
#include "io/space/tetrahedra_vtu_writer.hpp"
#include "tests/support/damaged_text.hpp"
#include "tests/support/tetrahedra_files.hpp"

namespace pcvt {
namespace {

using ::testing::HasSubstr;

EncodedFile encoded_tetrahedra(const space::TetrahedralMesh& mesh) {
    return encode_tetrahedra_vtu(mesh, "t.vtu").front();
}

std::string tetrahedra_fault(const std::string& piece, const std::string& other) {
    EncodedFile file = encoded_tetrahedra(testing::random_tetrahedra(8));
    file.bytes = testing::exchanged(file.bytes, piece, other);
    return testing::fault_of_tetrahedra(file);
}

TEST(TetrahedraVtu, GivesBackPointsSitesAndTetrahedra) {
    const auto cases = testing::tetrahedra_cases();
    EXPECT_GT(cases.size(), 45U);
    for (const auto& [name, mesh] : cases) {
        SCOPED_TRACE(name);
        const EncodedFile file = encoded_tetrahedra(mesh);
        ASSERT_EQ(space_file_kind({file}), SpaceFileKind::kTetrahedra);
        EXPECT_NO_THROW(prove_own_tetrahedra(file, mesh));
    }
}

TEST(TetrahedraVtu, OfAnotherProgramIsProvedWithoutItsWords) {
    EncodedFile file = encoded_tetrahedra(testing::random_tetrahedra(8));
    file.bytes = testing::exchanged(file.bytes, std::string(kTetrahedraVtuMark), "");
    file.bytes = testing::exchanged(file.bytes, "Int32\" Name=\"CellId", "Int64\" Name=\"CellId");
    EXPECT_EQ(testing::fault_of_tetrahedra(file), "");
    file.bytes = testing::exchanged(file.bytes, "Name=\"CellId\"", "Name=\"Cell\"");
    EXPECT_THAT(testing::fault_of_tetrahedra(file), HasSubstr("CellId"));
}

TEST(TetrahedraVtu, IsRefusedWhereItStatesSomethingElse) {
    EXPECT_EQ(tetrahedra_fault("<Cells>", "<Cells>"), "");
    EXPECT_THAT(tetrahedra_fault("Float64\" Name=\"Points", "Float32\" Name=\"Points"),
                HasSubstr("too coarse for a proof"));
    EXPECT_THAT(tetrahedra_fault("<PointData>", "<PointData >"), HasSubstr("another line follows"));
    EXPECT_THAT(tetrahedra_fault("\n10\n10\n", "\n14\n10\n"), HasSubstr("no tetrahedron"));
    EXPECT_THAT(tetrahedra_fault("\n4\n8\n", "\n3\n8\n"), HasSubstr("a tetrahedron has 4 points"));
    EXPECT_THAT(tetrahedra_fault("Name=\"PeriodicPointIds\" format=\"ascii\">\n0\n",
                                 "Name=\"PeriodicPointIds\" format=\"ascii\">\n3\n"),
                HasSubstr("point 0 is point 0 moved by (0, 0, 0)"));
    EXPECT_THAT(tetrahedra_fault("NumberOfPoints=\"", "NumberOfPoints=\"1"), HasSubstr("t.vtu"));
    EXPECT_THAT(tetrahedra_fault("1 0.2 0.1\n", "1.5 0.2 0.1\n"), HasSubstr("t.vtu"));
    EXPECT_THAT(tetrahedra_fault("1 0.2 0.1\n", "0 0 0\n"), HasSubstr("t.vtu:"));
}

TEST(TetrahedraVtu, RefutesOtherSitesAndTurnedTetrahedra) {
    space::TetrahedralMesh mesh = testing::random_tetrahedra(8);
    std::swap(mesh.tetrahedra[2][0], mesh.tetrahedra[2][1]);
    EXPECT_THAT(testing::fault_of_tetrahedra(encoded_tetrahedra(mesh)), HasSubstr("law (1)"));
    mesh = testing::random_tetrahedra(8);
    mesh.point_site[0] = (mesh.point_site[0] + 1) % 8;
    EXPECT_NE(testing::fault_of_tetrahedra(encoded_tetrahedra(mesh)), "");
    mesh = testing::random_tetrahedra(8);
    mesh.tetrahedra.pop_back();
    EXPECT_NE(testing::fault_of_tetrahedra(encoded_tetrahedra(mesh)), "");
}

}  // namespace
}  // namespace pcvt
