#include "io/run_files/yaml_reader.hpp"

#include <gmock/gmock.h>

#include "tests/support/damaged_text.hpp"
#include "tests/support/mutation.hpp"

namespace pcvt {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

/// A value in one line, whatever its style: scalars as they are, lists as [].
std::string in_one_line(const YamlValue& value) {
    if (value.is_list) return "[]";
    if (!value.is_mapping) return value.text;
    std::string text = "{";
    for (const auto& [key, member] : value.members) {
        text += (text.size() > 1 ? ", " : "") + key + ": " + in_one_line(member);
    }
    return text + "}";
}

std::string read_section(const std::string& text) {
    return in_one_line(parse_yaml("m.yaml", text, "phase"));
}

std::string yaml_fault(const std::string& text) {
    return testing::fault_in([&] { parse_yaml("m.yaml", text, "phase"); });
}

TEST(Yaml, BlocksAndBracesHoldTheSameValues) {
    const std::string expected =
        "{phase: {Al: {lattice: cF, mechanical: {elastic: {C_11: 1e+9}}}}}";
    for (const char* text :
         {"phase:\n  Al:\n    lattice: cF\n    mechanical:\n      elastic:\n        C_11: 1e+9\n",
          "phase:\n  Al: {lattice: cF, mechanical: {elastic: {C_11: 1e+9}}}",
          "phase: {Al: {lattice: cF,\n  mechanical: # mechanics\n {elastic: {C_11: 1e+9,\n}}}}\n",
          "---\r\n\"phase\":\r\n 'Al' :\r\n\r\n  lattice:   cF # of fcc\r\n  mechanical:\r\n"
          "# a comment\r\n   elastic: {'C_11' : 1e+9}\r\n...\r\nno: [YAML"}) {
        EXPECT_EQ(read_section(text), expected) << text;
    }
}

TEST(Yaml, OtherSectionsListsAndLongTextsAreSkipped) {
    EXPECT_EQ(
        read_section("%YAML 1.2\n---\n"
                     "homogenization:\n  SX: {N_constituents: 1}\n  x: &anchor !tag [1\n"
                     "material:\n- constituents:\n  - phase: A\n    O: [1.0, 0.0,\n 0.0, 0.0]\n"
                     "  homogenization: SX\n"
                     "text: |\n  phase:\n   no: 1\n\n  end\n"
                     "plain: a text\n  in two lines\n"
                     "phase:\n  A:\n    references:\n      - J. Doe, a: b,\n        1964\n"
                     "    output: [F, {a: b}, [1, 2]]\n    note: >\n     a: b\n\n     c\n"
                     "    slip:\n    - 1\n    - 2\n    empty:\n    last: 'it''s'\n"
                     "solver:\n  grid: x\n"),
        "{phase: {A: {references: [], output: [], note: , slip: [], empty: , last: it's}}}");
    EXPECT_EQ(read_section(""), "{}");
    EXPECT_EQ(read_section("# nothing\n"), "{}");
}

TEST(Yaml, MarksInsideOfWordsAreNoMarks) {
    EXPECT_EQ(read_section("phase:\n  a:b: c:d#e\n  'x: y': \"# z\" # w\n"),
              "{phase: {a:b: c:d#e, x: y: # z}}");
}

TEST(Yaml, FaultsNameTheirLine) {
    for (const auto& [text, words] : std::vector<std::pair<std::string, std::string>>{
             {"phase:\n  A: &a {x: 1}\n",
              "m.yaml:2: anchors, aliases and tags are not supported; "},
             {"phase:\n  A:\n    <<: *a\n", "m.yaml:3: anchors, aliases"},
             {"phase: {A: *a}\n", "m.yaml:1: anchors, aliases"},
             {"phase:\n  A: 1\n  A: 2\n", "m.yaml:3: 'A' is there twice; "},
             {"phase: {A: 1, A: 2}\n", "m.yaml:1: 'A' is there twice; "},
             {"phase: {}\nphase: {}\n", "m.yaml:2: 'phase' is there twice; "},
             {"phase:\n  A: {x: 1\n", ": a brace is not closed; "},
             {"phase:\n  A: {x: 1} y\n", "m.yaml:2: 'y' follows a value; "},
             {"phase:\n  A: {x: 1 {\n", "m.yaml:2: a comma is missing"},
             {"phase:\n  A: {x}\n", "m.yaml:2: 'x' is no key; "},
             {"phase:\n  A\n", "m.yaml:2: 'A' is no key; write KEY: VALUE"},
             {"phase:\n  A: 'x\n", "m.yaml:2: the quotes are not closed"},
             {"phase:\n  A: \"\\n\"\n", "m.yaml:2: \\ in quotes is not supported; "},
             {"phase:\n\tA: 1\n", "m.yaml:2: the line is indented by a tab; "},
             {"phase:\n    A: 1\n  B: 2\n", "m.yaml:3: the indentation fits no line above; "},
             {"phase:\n  A: 1\n    B: 2\n", "m.yaml:3: the indentation fits no line above; "},
             {"phase: {}\n---\nphase: {}\n", "m.yaml:2: a second document begins; "},
             {"phase: {x: }}\n", "m.yaml:1: '}' follows a value; "}}) {
        EXPECT_THAT(yaml_fault(text), HasSubstr(words)) << text;
    }
    std::string flow = "phase: ";
    for (int k = 0; k < 100; ++k) flow += "{a: ";
    EXPECT_THAT(yaml_fault(flow), HasSubstr("too deep; "));
    std::string deep = "phase:\n";
    for (int k = 1; k < 100; ++k) deep += std::string(k, ' ') + "a:\n";
    EXPECT_THAT(yaml_fault(deep), HasSubstr("too deep; "));
}

TEST(Yaml, DamagedFilesGiveAValueOrAFaultAndNothingElse) {
    const std::string text =
        "phase:\n  Al:\n    lattice: cF # cubic\n    mechanical:\n      output: [F, P]\n"
        "      elastic: {type: Hooke, C_11: 106.9e+9, 'C_12': 60.5e+9}\n  Ti:\n    a: |\n     "
        "text\n"
        "material:\n- homogenization: SX\n";
    std::mt19937_64 random(7);
    for (int k = 0; k < 2000; ++k) {
        const std::string fault = yaml_fault(testing::mutated(text, random));
        if (fault.empty()) continue;
        EXPECT_THAT(fault, StartsWith("m.yaml"));
        EXPECT_THAT(fault, HasSubstr("; "));
    }
}

}  // namespace
}  // namespace pcvt
