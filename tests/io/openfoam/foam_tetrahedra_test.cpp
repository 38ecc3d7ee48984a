#include "io/openfoam/foam_tetrahedra.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <sstream>

#include "io/openfoam/foam_writer.hpp"
#include "mesher/base/law_violation.hpp"
#include "tests/support/damaged_text.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/space_tiles.hpp"
#include "tests/support/tetrahedra_files.hpp"

namespace pcvt {
namespace {

using ::testing::HasSubstr;

std::vector<EncodedFile> case_of(const space::TetrahedralMesh& mesh) {
    const CellMaterials materials = testing::some_materials(mesh.cell.back() + 1);
    return encode_foam_tetrahedra(mesh, &materials, "t.foam");
}

/// The message of the proof of a case with one exchanged piece.
std::string fault_of(const std::string& name, const std::string& piece, const std::string& other) {
    static const std::vector<EncodedFile> files = case_of(testing::grain_tetrahedra(3));
    return testing::refusal_of(
        [&] { prove_tetrahedral_files(testing::exchanged(files, name, piece, other)); });
}

TEST(FoamTetrahedra, GiveBackTheMeshAndItsCells) {
    space::TetrahedralMesh mesh = testing::grain_tetrahedra(4);
    const CellMaterials materials = testing::some_materials(4);
    for (const int order : {1, 2}) {
        mesh.order = order;
        const std::vector<EncodedFile> files = encode_foam_tetrahedra(mesh, &materials, "t.foam");
        ASSERT_EQ(space_file_kind(files), SpaceFileKind::kTetrahedra);
        EXPECT_NO_THROW(prove_own_tetrahedra(files, mesh, &materials));
        const TetrahedralTile found = prove_tetrahedral_files(files).tile;
        EXPECT_EQ(found.mesh.cell, mesh.cell);
        EXPECT_EQ(found.mesh.order, 1);
        EXPECT_EQ(found.materials, materials);
        EXPECT_EQ(found.mesh.tetrahedra, with_sorted_corners(mesh).tetrahedra);
    }
    EXPECT_NO_THROW(
        prove_own_tetrahedra(encode_foam_tetrahedra(mesh, nullptr, "t.foam"), mesh, nullptr));
}

TEST(FoamTetrahedra, SortedCornersAreThoseOfAnyEvenPermutation) {
    space::TetrahedralMesh mesh = testing::grain_tetrahedra(2);
    const std::vector<std::array<int, 4>> sorted = with_sorted_corners(mesh).tetrahedra;
    for (std::array<int, 4>& corners : mesh.tetrahedra) {
        std::swap(corners[0], corners[1]);
        std::swap(corners[2], corners[3]);
    }
    EXPECT_EQ(with_sorted_corners(mesh).tetrahedra, sorted);
    for (const std::array<int, 4>& corners : sorted) {
        EXPECT_LT(corners[0], corners[1]);
        EXPECT_LT(corners[1], std::min(corners[2], corners[3]));
    }
}

TEST(FoamTetrahedra, HaveAZoneOfEachCellAndPhase) {
    const std::vector<EncodedFile> files = case_of(testing::grain_tetrahedra(3));
    const auto zones = std::find_if(files.begin(), files.end(), [](const EncodedFile& file) {
        return file.path.ends_with("/cellZones");
    });
    for (const char* name :
         {"\ncell_0\n", "\ncell_1\n", "\ncell_2\n", "\nphase_a\n", "\nphase_b\n"}) {
        EXPECT_THAT(zones->bytes, HasSubstr(name));
    }
}

/// The cells in a zone of a case.
std::vector<int> members_of(const std::string& zones, const std::string& name) {
    const std::size_t begin = zones.find('(', zones.find("\n" + name + "\n"));
    std::istringstream numbers(zones.substr(begin + 1, zones.find(')', begin) - begin - 1));
    return {std::istream_iterator<int>(numbers), std::istream_iterator<int>()};
}

TEST(FoamTetrahedra, ZonesHoldTheTetrahedraOfTheirCellsAndPhases) {
    const space::TetrahedralMesh mesh = testing::grain_tetrahedra(3);
    const CellMaterials materials{.phase_names = {"a", "b"}, .site_phase = {1, 0, 1}};
    std::string zones;
    for (const EncodedFile& file : encode_foam_tetrahedra(mesh, &materials, "t.foam")) {
        if (file.path.ends_with("/cellZones")) zones = file.bytes;
    }
    std::array<std::vector<int>, 3> of_cells;
    std::array<std::vector<int>, 2> of_phases;
    for (int t = 0; t < mesh.n_tetrahedra(); ++t) {
        of_cells[mesh.cell[t]].push_back(t);
        of_phases[mesh.cell[t] == 1 ? 0 : 1].push_back(t);
    }
    for (std::size_t s = 0; s < 3; ++s) {
        EXPECT_EQ(members_of(zones, "cell_" + std::to_string(s)), of_cells[s]);
    }
    EXPECT_EQ(members_of(zones, "phase_a"), of_phases[0]);
    EXPECT_EQ(members_of(zones, "phase_b"), of_phases[1]);
}

TEST(FoamTetrahedra, OtherStatementsAreRefused) {
    EXPECT_EQ(fault_of("boundary", "FoamFile", "FoamFile"), "");
    EXPECT_THAT(fault_of("boundary", "// pcvt cell_tetrahedra ", "// pcvt cell_tetrahedra 1"),
                HasSubstr("do not sum to"));
    EXPECT_THAT(fault_of("boundary", "// pcvt cell_tetrahedra ", "// pcvt cells "),
                HasSubstr("do not sum to"));
    EXPECT_THAT(fault_of("boundary", "// pcvt phases", "// pcvt cell_tetrahedra 1\n// pcvt phases"),
                HasSubstr("do not sum to"));
    EXPECT_THAT(fault_of("boundary", "// pcvt lattice", "// lattice"),
                HasSubstr("not one lattice"));
    EXPECT_THAT(fault_of("cellZones", "\ncell_1\n", "\ncell_7\n"), HasSubstr("cellZones"));
    EXPECT_THAT(fault_of("cellZones", "\n(\n0\n", "\n(\n1\n"), HasSubstr("cellZones"));
    EXPECT_THAT(fault_of("0/U", "type cyclic", "type empty"), HasSubstr("0/U"));
    EXPECT_THAT(fault_of("owner", "\n(\n0\n", "\n(\n-1\n"),
                HasSubstr("face 0 refers to a cell that does not exist"));
    EXPECT_THAT(fault_of("faces", "\n3(", "\n2("), HasSubstr("faces"));
    EXPECT_NE(fault_of("points", "\n(\n(", "\n(\n(1"), "");
}

TEST(FoamTetrahedra, FacesOfOtherCellsAreRefuted) {
    const space::TetrahedralMesh mesh = testing::grain_tetrahedra(2);
    std::vector<EncodedFile> files = encode_foam_tetrahedra(mesh, nullptr, "t.foam");
    for (EncodedFile& file : files) {
        if (!file.path.ends_with("/faces")) continue;
        // The first face is traversed the other way round.
        const std::size_t begin = file.bytes.find("3(") + 2;
        const std::size_t end = file.bytes.find(')', begin);
        std::istringstream words(file.bytes.substr(begin, end - begin));
        std::string a;
        std::string b;
        std::string c;
        words >> a >> b >> c;
        file.bytes.replace(begin, end - begin, a + " " + c + " " + b);
    }
    EXPECT_THROW(prove_tetrahedral_files(files), NotATile);
}

}  // namespace
}  // namespace pcvt
