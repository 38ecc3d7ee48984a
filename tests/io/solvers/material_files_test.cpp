#include <gmock/gmock.h>

#include <algorithm>
#include <map>
#include <set>

#include "io/bytes/text.hpp"
#include "io/formats/file_proof.hpp"
#include "io/forms/triangle_elements.hpp"
#include "io/solvers/inp_reader.hpp"
#include "io/solvers/inp_sections.hpp"
#include "io/solvers/inp_writer.hpp"
#include "io/solvers/msh_reader.hpp"
#include "io/solvers/msh_writer.hpp"
#include "mesher/cells/orientations.hpp"
#include "mesher/plane/tile/build_tile.hpp"
#include "tests/support/damaged_text.hpp"
#include "tests/support/mutation.hpp"

namespace pcvt {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

constexpr int kSites = 20;

plane::Tile grains(plane::Outline outline, int columns = 1) {
    const plane::Lattice lattice({1, 0}, {0.37, 0.81});
    return build_tile(
               plane::PeriodicDelaunay(plane::Sites(lattice, uniform_points(lattice, kSites, 3))),
               {.kind = plane::MeshKind::kGrains, .outline = outline, .repeat = {columns, 1}})
        .tile;
}

CellMaterials all_materials() {
    CellMaterials materials{.phase_names = {"ferrite", "M-2_x"},
                            .site_orientation = random_orientations(kSites, 2)};
    for (int s = 0; s < kSites; ++s) materials.site_phase.push_back(s % 3 == 0 ? 0 : 1);
    return materials;
}

std::string inp_text(const CellMaterials& materials, SolverJob job = SolverJob::kNone) {
    return encode_inp(grains(plane::Outline::kWhole), {.materials = &materials, .job = job},
                      "t.inp")[0]
        .bytes;
}

std::string msh_text(const CellMaterials& materials) {
    return encode_msh(entity_mesh(grains(plane::Outline::kWhole), &materials), "t.msh")[0].bytes;
}

std::string refusal_of(const std::string& path, const std::string& text) {
    return testing::fault_in([&] {
        const Format& format = *find_format(path);
        const std::vector<EncodedFile> files{{path, text}};
        prove_file(format, files, decode_tile(format, files, std::nullopt));
    });
}

TEST(MaterialFiles, InputsReadBackPhasesAndOrientations) {
    for (const plane::Outline outline : {plane::Outline::kWhole, plane::Outline::kBox}) {
        for (const int columns : {1, 2}) {
            const plane::Tile tile = grains(outline, columns);
            CellMaterials materials = all_materials();
            EXPECT_EQ(
                decode_inp(encode_inp(tile, {.materials = &materials}, "t.inp"), {}).materials,
                materials);
            materials.site_orientation.clear();
            EXPECT_EQ(
                decode_inp(encode_inp(tile, {.materials = &materials}, "t.inp"), {}).materials,
                materials);
            EXPECT_EQ(decode_msh(encode_msh(entity_mesh(tile, &materials), "t.msh"), {}).materials,
                      materials);
        }
    }
    CellMaterials turned{.site_orientation = random_orientations(kSites, 2)};
    EXPECT_EQ(refusal_of("t.inp", inp_text(turned)), "");
    EXPECT_THAT(inp_text(turned), HasSubstr("*SOLID SECTION,ELSET=CELL_3,MATERIAL=GRAINS,"
                                            "ORIENTATION=ORI_3\n1.\n"));
}

TEST(MaterialFiles, EachCellHasTheSectionOfItsPhaseAndTheAxesOfItsOrientation) {
    const CellMaterials materials = all_materials();
    const std::string text = inp_text(materials);
    for (int s = 0; s < kSites; ++s) {
        const std::string id = std::to_string(s);
        EXPECT_THAT(text, HasSubstr("*SOLID SECTION,ELSET=CELL_" + id +
                                    ",MATERIAL=" + (s % 3 == 0 ? "ferrite" : "M-2_x") +
                                    ",ORIENTATION=ORI_" + id + "\n1.\n"));
        const std::string card = "*ORIENTATION,NAME=ORI_" + id + "\n";
        ASSERT_THAT(text, HasSubstr(card));
        std::string row = text.substr(text.find(card) + card.size());
        std::replace(row.begin(), row.end(), ',', ' ');
        LineScanner scanner("row", row);
        scanner.next();
        ASSERT_EQ(scanner.words().size(), 6u);
        const Eigen::Matrix3d g = bunge_matrix(materials.site_orientation[s]);
        for (int k = 0; k < 6; ++k) {
            EXPECT_LE(scanner.words()[k].size(), 20u);
            EXPECT_NEAR(scanner.number(scanner.words()[k]), g(k / 3, k % 3), 1.2e-16);
        }
    }
    EXPECT_THAT(text, HasSubstr("*ELSET,ELSET=PHASE_ferrite\nCELL_0,CELL_3,CELL_6,CELL_9,CELL_12,"
                                "CELL_15,CELL_18\n"));
    EXPECT_THAT(text, Not(HasSubstr("*MATERIAL")));
    EXPECT_THAT(text, Not(HasSubstr("*STEP")));
}

TEST(MaterialFiles, AJobHasOneMaterialAPhaseAndThreeSteps) {
    CellMaterials materials = all_materials();
    std::string text = inp_text(materials, SolverJob::kElastic);
    EXPECT_THAT(text, HasSubstr("*MATERIAL,NAME=ferrite\n*ELASTIC,TYPE=ORTHO\n231400.,"));
    EXPECT_THAT(text, HasSubstr("*MATERIAL,NAME=M-2_x\n"));
    EXPECT_THAT(text, HasSubstr("CONTROL_1,1,1,0.\nCONTROL_1,2,2,0.5\nCONTROL_2,2,2,0.\n"));
    EXPECT_EQ(refusal_of("t.inp", text), "");
    materials.site_orientation.clear();
    text = inp_text(materials, SolverJob::kElastic);
    EXPECT_THAT(text, HasSubstr("*MATERIAL,NAME=ferrite\n*ELASTIC\n210000.,0.3\n"));
    EXPECT_EQ(refusal_of("t.inp", text), "");
    // A job without materials of its own cells.
    text = encode_inp(grains(plane::Outline::kBox), {.job = SolverJob::kElastic}, "t.inp")[0].bytes;
    EXPECT_THAT(text, HasSubstr("*SOLID SECTION,ELSET=EALL,MATERIAL=GRAINS\n1.\n"));
    EXPECT_EQ(refusal_of("t.inp", text), "");
}

TEST(MaterialFiles, AJobHasTheConstantsThatTheUserChooses) {
    const CellMaterials materials = all_materials();
    const ElasticChoices choices =
        parse_elastic_choices("ferrite:0.3333333333333333,-0.25 m-2_x:162.4,92,69,180.7,46.7");
    const std::string text =
        encode_inp(grains(plane::Outline::kWhole),
                   {.materials = &materials, .job = SolverJob::kElastic, .elastic = choices},
                   "t.inp")[0]
            .bytes;
    EXPECT_THAT(text, HasSubstr("*MATERIAL,NAME=ferrite\n*ELASTIC\n0.3333333333333333,-0.25\n"));
    EXPECT_THAT(text, HasSubstr("*MATERIAL,NAME=M-2_x\n*ELASTIC,TYPE=ORTHO\n"
                                "162.4,92.,162.4,69.,69.,180.7,35.2,46.7\n46.7\n"));
    EXPECT_THAT(text, HasSubstr("the constants are those that the user gave"));
    EXPECT_EQ(refusal_of("t.inp", text), "");
}

/// The refusal of a text with `piece` replaced by `other`.
std::string refusal_with(const std::string& path, const std::string& text, const std::string& piece,
                         const std::string& other) {
    return refusal_of(path, testing::exchanged(text, piece, other));
}

TEST(MaterialFiles, InputsWithAnotherPhaseOrOrientationAreRefused) {
    const std::string text = inp_text(all_materials(), SolverJob::kElastic);
    ASSERT_EQ(refusal_of("t.inp", text), "");
    const auto refusal = [&](const std::string& piece, const std::string& other) {
        return refusal_with("t.inp", text, piece, other);
    };
    EXPECT_THAT(refusal("ELSET=CELL_0,MATERIAL=ferrite", "ELSET=CELL_0,MATERIAL=M-2_x"),
                HasSubstr("*SOLIDSECTION,ELSET=CELL_0"));
    EXPECT_NE(refusal("ORIENTATION=ORI_4\n", "ORIENTATION=ORI_5\n"), "");
    EXPECT_NE(refusal("CELL_0,CELL_3,", "CELL_0,CELL_4,"), "");
    EXPECT_NE(refusal("pcvt site_phases 0 1", "pcvt site_phases 1 1"), "");
    EXPECT_THAT(refusal("pcvt site_phases 0 1", "pcvt site_phases 2 1"),
                HasSubstr("there is no phase '2'"));
    EXPECT_THAT(refusal("pcvt site_phases 0 1", "pcvt site_phases 1"),
                HasSubstr("there are phases of 19 sites for 20 sites"));
    EXPECT_THAT(refusal("pcvt phases ferrite", "pcvt phases f,"),
                HasSubstr("not the name of a phase"));
    EXPECT_THAT(refusal("pcvt phases ferrite", "pcvt phases m-2_X"), HasSubstr("given twice"));
    EXPECT_NE(refusal("pcvt angles ", "pcvt angles 1"), "");
    // The constants and the steps are the user's.
    EXPECT_EQ(refusal("231400.,134700.", "200000.,100000."), "");
    EXPECT_EQ(refusal("CONTROL_1,1,1,1.", "CONTROL_1,1,1,0.001"), "");
}

TEST(MaterialFiles, TheSectionsOfAUserAreTheirOwn) {
    const std::string text = encode_inp(grains(plane::Outline::kWhole), {}, "t.inp")[0].bytes;
    EXPECT_EQ(refusal_of("t.inp", text + "*ELSET,ELSET=PHASE_X\nCELL_1\n*ORIENTATION,NAME=O\n"
                                         "1,0,0,0,1,0\n*SOLID SECTION,ELSET=CELL_0,MATERIAL=X\n"),
              "");
}

/// The physical groups of each surface, by name.
std::map<int, std::vector<std::string>> groups_of_surfaces(const std::string& text) {
    LineScanner scanner("t.msh", text);
    std::map<int, std::string> names;
    std::map<int, std::vector<std::string>> groups;
    const auto go_to = [&](std::string_view section) {
        while (scanner.next()) {
            if (scanner.words().size() == 1 && scanner.words()[0] == section) return;
        }
    };
    go_to("$PhysicalNames");
    scanner.next();
    for (int k = scanner.integer(scanner.words()[0]); k > 0; --k) {
        scanner.next();
        names[scanner.integer(scanner.words()[1])] = scanner.words()[2];
    }
    go_to("$Entities");
    scanner.next();
    const int n_before = scanner.integer(scanner.words()[0]) + scanner.integer(scanner.words()[1]);
    const int n_surfaces = scanner.integer(scanner.words()[2]);
    for (int k = 0; k < n_before; ++k) scanner.next();
    for (int k = 0; k < n_surfaces; ++k) {
        scanner.next();
        const auto& words = scanner.words();
        for (int g = 0; g < scanner.integer(words[7]); ++g) {
            groups[scanner.integer(words[0]) - 1].push_back(
                names.at(scanner.integer(words[8 + g])));
        }
    }
    return groups;
}

TEST(MaterialFiles, EachSurfaceIsInTheGroupsOfItsCellAndItsPhase) {
    const auto groups = groups_of_surfaces(msh_text(all_materials()));
    ASSERT_EQ(groups.size(), static_cast<std::size_t>(kSites));
    for (const auto& [site, names] : groups) {
        EXPECT_EQ(names, (std::vector<std::string>{
                             "\"cell_" + std::to_string(site) + "\"",
                             site % 3 == 0 ? "\"phase_ferrite\"" : "\"phase_M-2_x\""}));
    }
}

TEST(MaterialFiles, APhaseWithoutCellsHasNoGroup) {
    CellMaterials materials = all_materials();
    materials.phase_names.emplace_back("rare");
    const std::string text = msh_text(materials);
    EXPECT_THAT(text, Not(HasSubstr("phase_rare")));
    EXPECT_EQ(refusal_of("t.msh", text), "");
    EXPECT_THAT(inp_text(materials), Not(HasSubstr("PHASE_rare")));
    EXPECT_EQ(refusal_of("t.inp", inp_text(materials)), "");
}

TEST(MaterialFiles, MeshesWithAnotherPhaseAreRefused) {
    const std::string text = msh_text(all_materials());
    ASSERT_EQ(refusal_of("t.msh", text), "");
    EXPECT_NE(refusal_with("t.msh", text, "\"phase_ferrite\"", "\"phase_other\""), "");
    EXPECT_NE(refusal_with("t.msh", text, "pcvt site_phases 0 1", "pcvt site_phases 1 1"), "");
    EXPECT_NE(refusal_with("t.msh", text, "pcvt phases ferrite", "pcvt phases Ferrite"), "");
}

}  // namespace
}  // namespace pcvt
