#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "io/bytes/text.hpp"
#include "io/forms/seam_entities.hpp"
#include "io/forms/tetrahedra_entities.hpp"
#include "io/solvers/msh_writer.hpp"
#include "mesher/plane/proof/validate.hpp"
#include "tests/support/damaged_text.hpp"
#include "tests/support/msh_links.hpp"
#include "tests/support/tetrahedra_files.hpp"

namespace pcvt {
namespace {

using ::testing::HasSubstr;

EncodedFile tetrahedra_msh(const space::TetrahedralMesh& mesh) {
    return encode_msh(entity_mesh(mesh), "t.msh").front();
}

std::string tetrahedra_msh_fault(const std::string& piece, const std::string& other) {
    EncodedFile file = tetrahedra_msh(testing::random_tetrahedra(8));
    file.bytes = testing::exchanged(file.bytes, piece, other);
    return testing::fault_of_tetrahedra(file);
}

TEST(MshTetrahedra, GivesBackPointsSitesAndTetrahedra) {
    const auto cases = testing::tetrahedra_cases();
    EXPECT_GT(cases.size(), 45U);
    for (const auto& [name, mesh] : cases) {
        SCOPED_TRACE(name);
        const EncodedFile file = tetrahedra_msh(mesh);
        ASSERT_EQ(space_file_kind({file}), SpaceFileKind::kTetrahedra);
        const space::TetrahedralMesh found = prove_tetrahedral_files({file}).tile.mesh;
        EXPECT_EQ(found.points, mesh.points);
        EXPECT_EQ(found.point_site, mesh.point_site);
        EXPECT_EQ(found.point_offset, mesh.point_offset);
        EXPECT_EQ(found.tetrahedra, mesh.tetrahedra);
    }
}

TEST(MshTetrahedra, InsideOfCellsAreGivenBackWithTheirCells) {
    const space::TetrahedralMesh mesh = testing::grain_tetrahedra(6);
    const EncodedFile file = tetrahedra_msh(mesh);
    ASSERT_EQ(space_file_kind({file}), SpaceFileKind::kTetrahedra);
    EXPECT_NO_THROW(prove_own_tetrahedra({file}, mesh));
    EXPECT_EQ(prove_tetrahedral_files({file}).tile.mesh.cell, mesh.cell);
    EXPECT_THAT(file.bytes, HasSubstr("\"cell_5\""));
    // Whichever links of a node a program keeps, it finds as many unknowns as there are nodes.
    testing::expect_orbits(file.bytes, prove_tetrahedra(mesh).n_sites);
    EncodedFile damaged = file;
    damaged.bytes = testing::exchanged(file.bytes, "$ElementData", "$ElementDate");
    EXPECT_NE(testing::fault_of_tetrahedra(damaged), "");
}

TEST(MshTetrahedra, TiesEachNodeByAnyOfItsLinksAndBySurfacesAlone) {
    for (const auto& [name, mesh] : testing::tetrahedra_cases()) {
        SCOPED_TRACE(name);
        testing::expect_orbits(tetrahedra_msh(mesh).bytes, prove_tetrahedra(mesh).n_sites);
    }
}

/// The numbers behind `word`, row by row, in the section that begins with `section`.
std::vector<int> first_numbers(const std::string& msh, const std::string& section, int n_skipped) {
    std::istringstream text(msh.substr(msh.find(section)));
    std::vector<int> numbers;
    std::string row;
    for (int k = 0; std::getline(text, row) && !row.starts_with("$End"); ++k) {
        if (k > n_skipped) numbers.push_back(std::stoi(row));
    }
    return numbers;
}

TEST(MshTetrahedra, GroupsAllElementsAndListsSitesInTheOrderOfNodes) {
    const space::TetrahedralMesh mesh = testing::random_tetrahedra(30);
    const std::string msh = tetrahedra_msh(mesh).bytes;
    // The rows of $Nodes with one word are the numbers of the nodes.
    std::istringstream text(msh.substr(msh.find("$Nodes\n")));
    std::vector<int> nodes;
    for (std::string row; std::getline(text, row) && row != "$EndNodes";) {
        if (row.find(' ') == std::string::npos && row != "$Nodes") nodes.push_back(std::stoi(row));
    }
    constexpr int kTags = 8;
    EXPECT_EQ(first_numbers(msh, "$NodeData", kTags), nodes);
    EXPECT_EQ(msh.find("\n1 1 1 "), std::string::npos) << "a block of lines";
}

TEST(MshTetrahedra, IsRefusedWhereItStatesSomethingElse) {
    EXPECT_EQ(tetrahedra_msh_fault("written by pcvt", "written by pcvt"), "");
    EXPECT_THAT(tetrahedra_msh_fault("pcvt lattice 1", "pcvt lattice 1 1"),
                HasSubstr("nine numbers"));
    EXPECT_THAT(tetrahedra_msh_fault("pcvt lattice 1", "pcvt lattice 2"), HasSubstr("law"));
    EXPECT_THAT(tetrahedra_msh_fault("pcvt lattice", "pcvt lettice"),
                HasSubstr("the lattice comes before"));
    EXPECT_THAT(tetrahedra_msh_fault("\"domain\"", "\"demain\""), HasSubstr("domain"));
    EXPECT_THAT(tetrahedra_msh_fault("\"seam_", "\"team_"), HasSubstr("seam_"));
    EXPECT_THAT(tetrahedra_msh_fault("$Elements\n", "$Elements\n7"), HasSubstr("t.msh:"));
    EXPECT_THAT(tetrahedra_msh_fault("\"cell_id\"", "\"other\""), HasSubstr("site of each node"));
    EXPECT_THAT(tetrahedra_msh_fault("$Periodic\n", "$Periodic\n1"), HasSubstr("$Periodic"));
    EXPECT_THAT(tetrahedra_msh_fault("$EndNodes\n", "7 7 7\n$EndNodes\n"),
                HasSubstr("more lines than its count"));
}

TEST(MshTetrahedra, RefutesAMovedNode) {
    space::TetrahedralMesh mesh = testing::random_tetrahedra(8);
    EncodedFile file = tetrahedra_msh(mesh);
    std::string word;
    append_number(word, mesh.points[0].x());
    file.bytes = testing::exchanged(file.bytes, "\n" + word + " ", "\n0.123 ");
    EXPECT_NE(testing::fault_of_tetrahedra(file), "");
}

/// Expects that one point is the image of another one by a translation.
void expect_image(const space::TetrahedralMesh& mesh, int v, int of, space::Offset offset) {
    EXPECT_EQ(mesh.point_site[v], mesh.point_site[of]);
    EXPECT_EQ(mesh.point_offset[v] - mesh.point_offset[of], offset);
}

TEST(SeamEntities, PutEachPairOfTrianglesOnASurfaceAndItsPartner) {
    for (const auto& [name, mesh] : testing::tetrahedra_cases()) {
        SCOPED_TRACE(name);
        const space::TetrahedralProof proof = prove_tetrahedra(mesh);
        std::size_t n_triangles = 0;
        const SeamEntities entities = seam_entities(mesh, proof);
        for (const SeamSurface& surface : entities.surfaces) {
            const SeamSurface& partner = entities.surfaces[surface.partner];
            EXPECT_EQ(partner.offset, -surface.offset);
            ASSERT_EQ(partner.triangles.size(), surface.triangles.size());
            n_triangles += surface.triangles.size();
            for (std::size_t k = 0; k < surface.triangles.size(); ++k) {
                for (std::size_t i = 0; i < 3; ++i) {
                    expect_image(mesh, partner.triangles[k][(3 - i) % 3], surface.triangles[k][i],
                                 surface.offset);
                }
            }
        }
        EXPECT_EQ(n_triangles, 2 * proof.pairs.size());
    }
}

TEST(SeamEntities, PlaceEachPointOnceAndItsImagesAlike) {
    for (const auto& [name, mesh] : testing::tetrahedra_cases()) {
        SCOPED_TRACE(name);
        const SeamEntities entities = seam_entities(mesh, prove_tetrahedra(mesh));
        std::vector<int> places(mesh.points.size(), 0);
        std::vector<std::set<int>> kinds(mesh.points.size());
        const auto place = [&, &points = mesh](const std::vector<int>& list, int kind) {
            for (const int v : list) {
                ++places[v];
                kinds[points.point_site[v]].insert(kind);
            }
        };
        for (const SeamSurface& surface : entities.surfaces) place(surface.points, 2);
        for (const SeamCurve& curve : entities.curves) place(curve.points, 1);
        for (const SeamPoint& point : entities.points) place({point.point}, 0);
        for (const std::set<int>& kind : kinds) EXPECT_LE(kind.size(), 1U);
        for (const int v : entities.inner_points) ++places[v];
        EXPECT_EQ(places, std::vector<int>(mesh.points.size(), 1));
    }
}

TEST(SeamEntities, AreImagesOfTheirMasters) {
    for (const auto& [name, mesh] : testing::tetrahedra_cases()) {
        SCOPED_TRACE(name);
        const SeamEntities entities = seam_entities(mesh, prove_tetrahedra(mesh));
        for (const SeamCurve& curve : entities.curves) {
            const SeamCurve& master = entities.curves[curve.master];
            EXPECT_EQ(&entities.curves[master.master], &master);
            ASSERT_EQ(curve.edges.size(), master.edges.size());
            EXPECT_EQ(curve.points.size(), master.points.size());
            for (std::size_t k = 0; k < curve.edges.size(); ++k) {
                for (std::size_t i = 0; i < 2; ++i) {
                    expect_image(mesh, curve.edges[k][i], master.edges[k][i], curve.offset);
                }
            }
        }
        for (const SeamPoint& point : entities.points) {
            const SeamPoint& master = entities.points[point.master];
            EXPECT_EQ(&entities.points[master.master], &master);
            expect_image(mesh, point.point, master.point, point.offset);
        }
    }
}

}  // namespace
}  // namespace pcvt
