#include "io/run_files/material_reader.hpp"

#include <gmock/gmock.h>

#include <functional>

#include "io/run_files/material_file.hpp"
#include "io/voxels/damask_material.hpp"
#include "mesher/base/error.hpp"

namespace pcvt {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

const std::string kTwoMetals =
    "phase:\n"
    "  Aluminum:\n"
    "    lattice: cF\n"
    "    mechanical:\n"
    "      output: [F, P, F_e, F_p, L_p, O]\n"
    "      elastic: {type: Hooke, C_11: 106.9e+9, C_12: 60.5e+9, C_44: 28.4e+9}\n"
    "      plastic: {type: isotropic, M: 3}\n"
    "  Titanium:\n"
    "    lattice: hP\n"
    "    c/a: 1.587\n"
    "    mechanical:\n"
    "      elastic:\n"
    "        type: Hooke\n"
    "        C_11: 160.0e+9\n"
    "        C_11,T: -5.0e+7\n"
    "        C_12: 90.0e+9\n"
    "        C_13: 66.0e+9\n"
    "        C_33: 181.7e+9\n"
    "        C_44: 46.5e+9\n"
    "        T_ref: 300\n"
    "  Epoxy:\n"
    "    mechanical: {elastic: {type: Hooke, E: 3.5e9, NU: 0.35}}\n"
    "  Tin:\n"
    "    lattice: tI\n"
    "    mechanical: {elastic: {type: Hooke, C_11: 72e9, C_12: 59e9, C_13: 35e9, C_33: 88e9, "
    "C_44: 22e9, C_66: 24e9}}\n"
    "  Void: {lattice: cI}\n"
    "  Odd:\n"
    "    mechanical: {elastic: {type: Neo, C_11: 1}}\n"
    "  Soft:\n"
    "    mechanical: {elastic: {type: Hooke, C_11: 1e9, C_12: 2e9, C_44: 1e9}}\n"
    "  Word:\n"
    "    mechanical: {elastic: {E: x, nu: 0.3}}\n";

ElasticChoices of_two_metals() {
    ElasticChoices choices;
    add_material_file("m.yaml", kTwoMetals, choices);
    return choices;
}

std::string fault_of_call(const std::function<void()>& call) {
    try {
        call();
    } catch (const InvalidInput& fault) {
        return fault.what();
    }
    return {};
}

std::vector<NamedConstants> constants_of_phases(const ElasticChoices& choices,
                                                const std::vector<std::string>& phases) {
    require_materials_of(choices, phases);
    return chosen_materials(choices, {.phase_names = phases}, {{1, 0.25}});
}

TEST(MaterialFile, PhasesTakeTheConstantsOfTheirNames) {
    const auto found = constants_of_phases(of_two_metals(), {"titanium", "Aluminum", "epoxy"});
    EXPECT_THAT(
        found,
        ElementsAre(NamedConstants{"titanium", {{160e9, 90e9, 66e9, 181.7e9, 46.5e9}}, "m.yaml"},
                    NamedConstants{"Aluminum", {{106.9e9, 60.5e9, 28.4e9}}, "m.yaml"},
                    NamedConstants{"epoxy", {{3.5e9, 0.35}}, "m.yaml"}));
}

TEST(MaterialFile, AMaterialThatIsGivenReplacesThatOfTheFile) {
    ElasticChoices choices = parse_elastic_choices("aluminum:70,0.3");
    choices.of_files = of_two_metals().of_files;
    EXPECT_THAT(
        constants_of_phases(choices, {"Aluminum", "Titanium"}),
        ElementsAre(NamedConstants{"Aluminum", {{70, 0.3}}},
                    NamedConstants{"Titanium", {{160e9, 90e9, 66e9, 181.7e9, 46.5e9}}, "m.yaml"}));
}

TEST(MaterialFile, CellsWithoutPhasesTakeItsOnlyMaterial) {
    ElasticChoices choices;
    add_material_file("cu.yaml",
                      "phase: {Copper: {mechanical: {elastic: {C_11: 168.3, C_12: 122.1, C_44: "
                      "75.7}}}}",
                      choices);
    EXPECT_THAT(constants_of_phases(choices, {}),
                ElementsAre(NamedConstants{"GRAINS", {{168.3, 122.1, 75.7}}, "Copper of cu.yaml"}));
    EXPECT_THAT(
        fault_of_call([] { constants_of_phases(of_two_metals(), {}); }),
        HasSubstr("the phase GRAINS has no elastic constants; add --material GRAINS:E,NU, or "
                  "take one of the names in m.yaml: Aluminum, Titanium, "));
}

TEST(MaterialFile, FaultsCountWhereAPhaseNeedsTheMaterial) {
    const auto fault = [](const std::string& phase) {
        return fault_of_call([&] { constants_of_phases(of_two_metals(), {"Aluminum", phase}); });
    };
    EXPECT_THAT(fault("Tin"), HasSubstr("m.yaml:25: the constants are not those of a material that "
                                        "pcvt knows; give C_11, C_12, C_44, or"));
    EXPECT_THAT(fault("Void"),
                HasSubstr("m.yaml:26: the phase 'Void' has no elastic constants; add"));
    EXPECT_THAT(fault("Odd"), HasSubstr("m.yaml:28: the elastic law 'Neo' is not supported; "));
    EXPECT_THAT(fault("Soft"), HasSubstr("m.yaml:30: no crystal is stable with these constants; "));
    EXPECT_THAT(fault("Word"), HasSubstr("m.yaml:32: 'x' is not a number"));
    EXPECT_THAT(fault("Iron"), HasSubstr("the phase Iron has no elastic constants; "));
    ElasticChoices twice = of_two_metals();
    add_material_file("other.yaml", kTwoMetals, twice);
    EXPECT_THAT(fault_of_call([&] { constants_of_phases(twice, {"Aluminum"}); }),
                HasSubstr("Aluminum is in m.yaml and in other.yaml; remove one"));
}

TEST(MaterialFile, FilesWithoutPhasesAreRefused) {
    for (const char* text :
         {"", "type: Hooke\nC_11: 1\n", "phase:\n", "phase: {}\n", "phase: [A]\n"}) {
        EXPECT_THAT(fault_of_call([&] {
                        ElasticChoices choices;
                        add_material_file("m.yaml", text, choices);
                    }),
                    HasSubstr("m.yaml: holds no phase; write phase: {NAME: "))
            << text;
    }
}

TEST(MaterialFile, MaterialsThatPcvtWritesAreReadBack) {
    const std::vector<std::string> phases{"ferrite", "titanium"};
    const ElasticChoices choices = parse_elastic_choices(
        "ferrite:231.4e9,134.7e9,116.4e9 titanium:162e9,92e9,69e9,181e9,47e9");
    const std::string yaml =
        encode_damask_material(2, {.phase_names = phases, .site_phase = {0, 1}}, choices);
    ElasticChoices read;
    add_material_file("t.material.yaml", yaml, read);
    auto found = constants_of_phases(read, phases);
    for (NamedConstants& material : found) material.source = "";
    EXPECT_EQ(found, choices.materials);
}

TEST(ElasticChoicesOfFiles, LinesAreMaterialsOrFiles) {
    std::vector<std::string> files;
    EXPECT_EQ(read_elastic_choices("a:1,0.3\nb:2,0.3", files).materials.size(), 2U);
    EXPECT_TRUE(files.empty());
    EXPECT_THAT(fault_of_call([&] { read_elastic_choices("a:1,0.3\n no such file.yaml ", files); }),
                HasSubstr("no such file.yaml: cannot read"));
    EXPECT_THAT(files, ElementsAre("no such file.yaml"));
    files.clear();
    EXPECT_THAT(fault_of_call([&] { read_elastic_choices(" \n", files); }),
                HasSubstr("no material"));
}

}  // namespace
}  // namespace pcvt
