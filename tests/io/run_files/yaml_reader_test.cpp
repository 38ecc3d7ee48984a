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

std::string read_yaml(const std::string& text) { return in_one_line(parse_yaml("m.yaml", text)); }

std::string yaml_fault(const std::string& text) {
    return testing::fault_in([&] { parse_yaml("m.yaml", text); });
}

TEST(Yaml, BlocksAndBracesHoldTheSameValues) {
    const std::string expected =
        "{phase: {Al: {lattice: cF, mechanical: {elastic: {C_11: 1e+9}}}}}";
    for (const char* text :
         {"phase:\n  Al:\n    lattice: cF\n    mechanical:\n      elastic:\n        C_11: 1e+9\n",
          "phase:\n  Al: {lattice: cF, mechanical: {elastic: {C_11: 1e+9}}}",
          "phase: {Al: {lattice: cF,\n  mechanical: # mechanics\n {elastic: {C_11: 1e+9,\n}}}}\n",
          "phase:\n  Al: &al\n    lattice: cF\n    mechanical: &m {elastic: {C_11: 1e+9}}\n",
          "---\r\n\"phase\":\r\n 'Al' :\r\n\r\n  lattice:   cF # of fcc\r\n  mechanical:\r\n"
          "# a comment\r\n   elastic: {'C_11' : 1e+9}\r\n...\r\n"}) {
        EXPECT_EQ(read_yaml(text), expected) << text;
    }
}

TEST(Yaml, ListsTextsAndAliasesOfFilesOfDamaskAreRead) {
    EXPECT_EQ(
        read_yaml("%YAML 1.2\n---\n"
                  "homogenization:\n  SX: {N_constituents: 1}\n"
                  "material:\n- constituents:\n  - phase: A\n    O: [1.0, 0.0,\n 0.0, 0.0]\n"
                  "  homogenization: SX\n"
                  "text: |\n  phase:\n   no: 1\n"
                  "phase:\n  A: &a\n    output: [F, {a: b}, [1, 2]]\n    empty:\n"
                  "    last: 'it''s'\n  B: *a\n"),
        "{homogenization: {SX: {N_constituents: 1}}, material: [], text: phase:\n no: 1\n, phase: "
        "{A: {output: [], empty: , last: it's}, B: {output: [], empty: , last: it's}}}");
    EXPECT_EQ(read_yaml(""), "");
    EXPECT_EQ(read_yaml("# nothing\n"), "");
}

TEST(Yaml, MembersHaveTheLinesOfTheirKeys) {
    const YamlValue file = parse_yaml("m.yaml", "# one\nphase:\n  A:\n    b: {c: d,\n e: f}\n");
    const YamlValue* const phase = file.find("phase");
    ASSERT_NE(phase, nullptr);
    const YamlValue& a = phase->members.front().second;
    const YamlValue& b = a.members.front().second;
    EXPECT_EQ(phase->line, 2);
    EXPECT_EQ(a.line, 3);
    EXPECT_EQ(b.line, 4);
    EXPECT_EQ(b.find("e")->line, 5);
}

TEST(Yaml, FaultsNameTheirLine) {
    for (const auto& [text, words] : std::vector<std::pair<std::string, std::string>>{
             {"phase:\n  A: *a\n", "m.yaml:2: "},
             {"phase:\n  A: 1\n  A: 2\n", "m.yaml:3: 'A' is there twice; "},
             {"phase: {A: 1, A: 2}\n", "m.yaml:1: 'A' is there twice; "},
             {"phase: {}\nphase: {}\n", "m.yaml:2: 'phase' is there twice; "},
             {"phase:\n  ? [a, b]\n  : 1\n", "m.yaml:2: a key is not a word; "},
             {"phase:\n  A: {x: 1\n", "m.yaml:3: end of map flow not found; correct the YAML"},
             {"phase:\n  A: {x: 1} y\n", "m.yaml:2: "},
             {"phase:\n  A\n  B: 1\n", "m.yaml:3: "},
             {"phase:\n    A: 1\n  B: 2\n", "m.yaml:3: "},
             {"phase:\n  A: 1\n    B: 2\n", "m.yaml:3: "},
             {"phase: {}\n---\nphase: {}\n", "m.yaml:3: a second document begins; "}}) {
        EXPECT_THAT(yaml_fault(text), StartsWith(words)) << text;
    }
}

TEST(Yaml, DeepAndEndlessValuesAreRefused) {
    for (const int depth : {100, 100'000}) {
        std::string flow = "phase: ";
        for (int k = 0; k < depth; ++k) flow += "{a: ";
        EXPECT_THAT(yaml_fault(flow + std::string(depth, '}')), StartsWith("m.yaml:1: ")) << depth;
    }
    std::string aliases = "a0: {x: 1}\n";
    for (int k = 1; k < 30; ++k) {
        const std::string before = "*n" + std::to_string(k - 1);
        aliases += "a" + std::to_string(k) + ": &n" + std::to_string(k) + " ";
        aliases += k == 1 ? "{x: 1}\n" : "{x: " + before + ", y: " + before + "}\n";
    }
    EXPECT_THAT(yaml_fault(aliases), HasSubstr("are too many; "));
    EXPECT_THAT(yaml_fault("phase: &a {b: *a}\n"), HasSubstr("; "));
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
