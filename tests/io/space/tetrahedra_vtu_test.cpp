#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/space/tetrahedra_vtu_reader.hpp"
#include "io/space/tetrahedra_vtu_writer.hpp"
#include "io/space_file_proof.hpp"
#include "tests/support/damaged_text.hpp"
#include "tests/support/polyhedra.hpp"

namespace pcvt {
namespace {

using ::testing::HasSubstr;

TetrahedralMesh tetrahedra_of(const SpaceLattice& lattice, const Points3& points) {
    return tetrahedral_mesh(space_delaunay(SpaceSites(lattice, points)));
}

TetrahedralMesh random_mesh(int n) {
    const SpaceLattice oblique({1, 0.2, 0.1}, {-0.3, 0.9, 0.2}, {0.4, 0.3, 1.2});
    return tetrahedra_of(oblique, uniform_points(oblique, n, 3));
}

EncodedFile encoded(const TetrahedralMesh& mesh) {
    return encode_tetrahedra_vtu(mesh, "t.vtu").front();
}

/// The message of the proof; empty if it accepts the file.
std::string fault_in(const EncodedFile& file) {
    try {
        prove_tetrahedral_file(file);
    } catch (const InvalidInput& fault) {
        return fault.what();
    }
    return "";
}

std::string fault_of(const std::string& piece, const std::string& other) {
    EncodedFile file = encoded(random_mesh(8));
    file.bytes = testing::exchanged(file.bytes, piece, other);
    return fault_in(file);
}

TEST(TetrahedraVtu, GivesBackPointsSitesAndTetrahedra) {
    int n_proved = 0;
    for (const testing::SpaceCase& c : testing::space_cases()) {
        SCOPED_TRACE(c.name);
        const TetrahedralMesh mesh = tetrahedra_of(c.lattice, c.points);
        if (n_flat_tetrahedra(mesh, static_cast<int>(c.points.cols())) > 0) continue;
        const EncodedFile file = encoded(mesh);
        ASSERT_EQ(space_file_kind({file}), SpaceFileKind::kTetrahedra);
        EXPECT_NO_THROW(prove_own_tetrahedra(file, mesh));
        ++n_proved;
    }
    EXPECT_GT(n_proved, 45);
}

TEST(TetrahedraVtu, OfAnotherProgramIsProvedWithoutItsWords) {
    EncodedFile file = encoded(random_mesh(8));
    file.bytes = testing::exchanged(file.bytes, std::string(kTetrahedraVtuMark), "");
    file.bytes = testing::exchanged(file.bytes, "Int32\" Name=\"CellId", "Int64\" Name=\"CellId");
    EXPECT_EQ(fault_in(file), "");
    file.bytes = testing::exchanged(file.bytes, "Name=\"CellId\"", "Name=\"Cell\"");
    EXPECT_THAT(fault_in(file), HasSubstr("CellId"));
}

TEST(TetrahedraVtu, IsRefusedWhereItStatesSomethingElse) {
    EXPECT_EQ(fault_of("<Cells>", "<Cells>"), "");
    EXPECT_THAT(fault_of("Float64\" Name=\"Points", "Float32\" Name=\"Points"),
                HasSubstr("too coarse for a proof"));
    EXPECT_THAT(fault_of("<PointData>", "<PointData >"), HasSubstr("another line follows"));
    EXPECT_THAT(fault_of("\n10\n10\n", "\n14\n10\n"), HasSubstr("no tetrahedron"));
    EXPECT_THAT(fault_of("\n4\n8\n", "\n3\n8\n"), HasSubstr("a tetrahedron has 4 points"));
    EXPECT_THAT(fault_of("Name=\"PeriodicPointIds\" format=\"ascii\">\n0\n",
                         "Name=\"PeriodicPointIds\" format=\"ascii\">\n3\n"),
                HasSubstr("point 0 is point 0 moved by (0, 0, 0)"));
    EXPECT_THAT(fault_of("NumberOfPoints=\"", "NumberOfPoints=\"1"), HasSubstr("t.vtu"));
    EXPECT_THAT(fault_of("1 0.2 0.1\n", "1.5 0.2 0.1\n"), HasSubstr("t.vtu"));
    EXPECT_THAT(fault_of("1 0.2 0.1\n", "0 0 0\n"), HasSubstr("t.vtu:"));
}

TEST(TetrahedraVtu, RefutesOtherSitesAndTurnedTetrahedra) {
    TetrahedralMesh mesh = random_mesh(8);
    std::swap(mesh.tetrahedra[2][0], mesh.tetrahedra[2][1]);
    EXPECT_THAT(fault_in(encoded(mesh)), HasSubstr("law (1)"));
    mesh = random_mesh(8);
    mesh.point_site[0] = (mesh.point_site[0] + 1) % 8;
    EXPECT_NE(fault_in(encoded(mesh)), "");
    mesh = random_mesh(8);
    mesh.tetrahedra.pop_back();
    EXPECT_NE(fault_in(encoded(mesh)), "");
}

}  // namespace
}  // namespace pcvt
