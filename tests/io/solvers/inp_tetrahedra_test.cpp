#include "io/solvers/inp_tetrahedra.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <sstream>

#include "io/forms/tetrahedra_entities.hpp"
#include "io/solvers/msh_writer.hpp"
#include "io/solvers/vtu_writer.hpp"
#include "tests/support/damaged_text.hpp"
#include "tests/support/tetrahedra_files.hpp"

namespace pcvt {
namespace {

using ::testing::HasSubstr;

CellMaterials two_phases(int n) {
    CellMaterials materials{.phase_names = {"soft", "hard"}};
    for (int s = 0; s < n; ++s) {
        materials.site_phase.push_back(s % 2);
        materials.site_orientation.push_back({10.0 * s, 20.0, 30.0 - s});
    }
    return materials;
}

space::TetrahedralMesh grains_of_order(int n, int order) {
    space::TetrahedralMesh mesh = testing::grain_tetrahedra(n);
    mesh.order = order;
    return mesh;
}

EncodedFile tetrahedra_inp(const space::TetrahedralMesh& mesh, const FileOptions& options = {}) {
    return encode_tetrahedra_inp(mesh, options, "t.inp").front();
}

TEST(InpTetrahedra, GiveBackPointsSitesAndTetrahedra) {
    for (const auto& [name, mesh] : testing::tetrahedra_cases()) {
        SCOPED_TRACE(name);
        const EncodedFile file = tetrahedra_inp(mesh);
        ASSERT_EQ(space_file_kind({file}), SpaceFileKind::kTetrahedra);
        EXPECT_NO_THROW(prove_own_tetrahedra({file}, mesh));
    }
}

TEST(InpTetrahedra, OfBothOrdersAreGivenBackByAllFormats) {
    const CellMaterials materials = two_phases(5);
    for (const int order : {1, 2}) {
        SCOPED_TRACE(order);
        const space::TetrahedralMesh mesh = grains_of_order(5, order);
        const FileOptions options{.materials = &materials, .job = SolverJob::kElastic};
        for (const char* const path : {"t.inp", "t.msh", "t.vtu"}) {
            const EncodedFile file =
                find_format(path)->space->encode_tetrahedra(mesh, options, path).front();
            EXPECT_NO_THROW(prove_own_tetrahedra({file}, mesh, &materials)) << path;
            EXPECT_EQ(prove_tetrahedral_files({file}).tile.mesh.order, order) << path;
        }
    }
}

/// The displacement that a mean strain gives to each node of a file, and to its control nodes.
std::vector<double> strained_sum(const std::string& inp, const space::TetrahedralMesh& mesh,
                                 const Eigen::Matrix3d& strain) {
    const ElementMesh elements = element_mesh(mesh);
    const auto displacement = [&](int node, int i) {
        const int control = node - elements.n_nodes();
        if (control > 0) return strain(control - 1, i - 1);
        const auto& p = elements.nodes[node - 1];
        return (strain * space::Vec3(p[0], p[1], p[2]))[i - 1];
    };
    std::istringstream text(inp.substr(inp.find("*EQUATION\n") + 10));
    std::vector<double> sums;
    std::string line;
    while (std::getline(text, line) && line == "5") {
        std::string rest;
        std::getline(text, line);
        std::getline(text, rest);
        std::string terms = line + "," + rest;
        std::replace(terms.begin(), terms.end(), ',', ' ');
        std::istringstream words(terms);
        double sum = 0;
        int node = 0;
        int i = 0;
        double coefficient = 0;
        while (words >> node >> i >> coefficient) sum += coefficient * displacement(node, i);
        sums.push_back(sum);
    }
    return sums;
}

TEST(InpTetrahedra, EquationsHoldForEveryLinearDisplacement) {
    Eigen::Matrix3d strain;
    strain << 0.3, 0.7, -0.2, 0.7, -1.1, 0.4, -0.2, 0.4, 0.9;
    for (const int order : {1, 2}) {
        const space::TetrahedralMesh mesh = grains_of_order(4, order);
        const std::vector<double> sums = strained_sum(tetrahedra_inp(mesh).bytes, mesh, strain);
        const ElementMesh elements = element_mesh(mesh);
        std::size_t n_tied = 0;
        for (int v = 0; v < elements.n_nodes(); ++v) n_tied += elements.orbit[v] == v ? 0 : 1;
        EXPECT_EQ(sums.size(), 3 * n_tied);
        for (const double sum : sums) EXPECT_LE(std::abs(sum), 1e-13);
    }
}

std::string fault_of(const std::string& piece, const std::string& other) {
    static const CellMaterials materials = two_phases(3);
    static const EncodedFile whole =
        tetrahedra_inp(grains_of_order(3, 2), {.materials = &materials});
    EncodedFile file = whole;
    file.bytes = testing::exchanged(file.bytes, piece, other);
    return testing::fault_of_tetrahedra(file);
}

TEST(InpTetrahedra, AreRefusedWhereTheFileStatesSomethingElse) {
    EXPECT_EQ(fault_of("written by pcvt", "written by pcvt"), "");
    EXPECT_THAT(fault_of("pcvt lattice", "pcvt lettice"), HasSubstr("does not know"));
    EXPECT_THAT(fault_of("TYPE=C3D10", "TYPE=C3D8"), HasSubstr("are not tetrahedra"));
    EXPECT_THAT(fault_of("*NODE,NSET=NALL\n1,", "*NODE,NSET=NALL\n2,"), HasSubstr("occurs twice"));
    EXPECT_THAT(fault_of("ELSET=EALL\n1,", "ELSET=EALL\n2,"), HasSubstr("not numbered 1, 2"));
    EXPECT_THAT(fault_of("ELSET=CELL_2\n", "ELSET=CELL_1\n"), HasSubstr("t.inp"));
    EXPECT_THAT(fault_of("NSET=FIXED\n1\n", "NSET=FIXED\n2\n"), HasSubstr("FIXED"));
    EXPECT_THAT(fault_of("NSET=TRIPLE_LINES\n", "NSET=TRIPLE_LINE\n"), HasSubstr("TRIPLE_LINES"));
    EXPECT_THAT(fault_of("NAME=PHASE_soft_TO_hard", "NAME=PHASE_soft_TO_soft"),
                HasSubstr("PHASE_SOFT_TO_"));
    EXPECT_THAT(fault_of("*EQUATION\n5\n", "*EQUATION\n6\n"), HasSubstr("t.inp:"));
    EXPECT_THAT(fault_of(",1,1,", ",1,0.9,"), HasSubstr("*EQUATION"));
    EXPECT_THAT(fault_of("MATERIAL=hard", "MATERIAL=soft"), HasSubstr("*SOLIDSECTION"));
    EXPECT_THAT(fault_of("** pcvt phases soft hard", "** pcvt phases soft"), HasSubstr("no phase"));
}

/// The bytes of a file of order 2 with another position of the last node.
EncodedFile moved_last_node(EncodedFile file, const std::string& before,
                            const std::string& behind) {
    const std::size_t end = file.bytes.find(behind, file.bytes.find(before));
    const std::size_t begin = file.bytes.rfind('\n', end - 1) + 1;
    const std::size_t digit = file.bytes.find_first_of("123456789", file.bytes.find('.', begin));
    file.bytes[digit] = file.bytes[digit] == '5' ? '6' : '5';
    return file;
}

TEST(MiddleNodes, AreRefusedOffTheMiddleOfTheirEdges) {
    const space::TetrahedralMesh mesh = grains_of_order(3, 2);
    EXPECT_THAT(testing::fault_of_tetrahedra(moved_last_node(
                    tetrahedra_inp(mesh), "*NODE,NSET=NALL", "\n*NODE,NSET=CONTROL_1")),
                HasSubstr("is not in the middle of its edge; take straight edges"));
    EXPECT_THAT(testing::fault_of_tetrahedra(moved_last_node(
                    encode_msh(entity_mesh(mesh), "t.msh").front(), "$Nodes", "\n$EndNodes")),
                HasSubstr("is not in the middle of its edge"));
    EXPECT_THAT(testing::fault_of_tetrahedra(moved_last_node(
                    encode_vtu(vtu_grid(mesh), "t.vtu").front(), "<Points>", "\n</DataArray>")),
                HasSubstr("is not in the middle of its edge"));
}

TEST(MiddleNodes, AreExchangedForGmsh) {
    const space::TetrahedralMesh mesh = grains_of_order(2, 2);
    const std::string msh = encode_msh(entity_mesh(mesh), "t.msh").front().bytes;
    const ElementMesh elements = element_mesh(mesh);
    std::string row = "\n1";
    for (const std::size_t k : {0, 1, 2, 3, 4, 5, 6, 7, 9, 8}) {
        row += " " + std::to_string(elements.elements.nodes[0][k] + 1);
    }
    EXPECT_THAT(msh, HasSubstr(row + "\n"));
}

}  // namespace
}  // namespace pcvt
