#include "io/run_files/phase_reader.hpp"

#include <gmock/gmock.h>

#include <string>

namespace pcvt {
namespace {

using ::testing::ElementsAre;

/// The phases of the sites with blanks between them, or the fault.
std::string phases_of(std::string_view text, const std::vector<std::string>& columns = {}) {
    try {
        const PhaseFile file = parse_phase_table({.path = "p.csv", .columns = columns}, text);
        std::string words;
        for (const int phase : file.site_phases) {
            words += (words.empty() ? "" : " ") + file.names[std::size_t(phase)];
        }
        return words;
    } catch (const BadFile& fault) {
        return fault.what();
    }
}

TEST(PhaseReader, PhasesAreNumberedAsTheTableNamesThem) {
    const PhaseFile file = parse_phase_table({.path = "p.csv"}, "b\na\nb\nc-2\na\n");
    EXPECT_THAT(file.names, ElementsAre("b", "a", "c-2"));
    EXPECT_THAT(file.site_phases, ElementsAre(0, 1, 0, 2, 1));
}

TEST(PhaseReader, AFirstLineOfAWordIsAPhaseUnlessItIsTheWordPhase) {
    EXPECT_EQ(phases_of("ferrite\naustenite\n"), "ferrite austenite");
    for (const char* header : {"phase", "Phases", "PHASE", "Phase_ID", "phase name"}) {
        EXPECT_EQ(phases_of(std::string(header) + "\nferrite\n"), "ferrite") << header;
    }
    EXPECT_EQ(phases_of("# the alloy\n\na # tail\r\n\r\nb"), "a b");
}

TEST(PhaseReader, NumbersAreNamesOfPhases) {
    EXPECT_EQ(phases_of("1\n2\n1\n"), "1 2 1");
    EXPECT_EQ(phases_of("phase\n01\n1\n"), "01 1");
    EXPECT_EQ(phases_of("1\nferrite\n"), "1 ferrite");
    EXPECT_EQ(phases_of("-1\n"), "-1");
}

TEST(PhaseReader, ColumnsAreFoundOrNamed) {
    EXPECT_EQ(phases_of("id,phase,ECD\n1,a,3\n2,b,4\n"), "a b");
    EXPECT_EQ(phases_of("id;Phase ID\n1;2\n2;1\n"), "2 1");
    EXPECT_EQ(phases_of("id,material\n1,steel\n", {"material"}), "steel");
    EXPECT_EQ(phases_of("1 a\n2 b\n", {"2"}), "a b");
    EXPECT_EQ(phases_of("material\nsteel\niron\n", {"material"}), "steel iron");
    EXPECT_EQ(phases_of("steel\niron\n", {"1"}), "steel iron");
}

TEST(PhaseReader, WrongTablesAreOneLineWithARemedy) {
    EXPECT_EQ(phases_of("id,ECD\n1,2\n"),
              "p.csv:1: the table has several columns; name that of the phases, such as p.csv:ECD");
    EXPECT_EQ(phases_of("1 a\n2 b\n"),
              "p.csv:1: the table has several columns; name that of the phases, such as p.csv:2");
    EXPECT_EQ(phases_of("steel\nIron bcc\n"),
              "p.csv:2: this line has 2 words; write one phase a line");
    EXPECT_EQ(phases_of("Iron bcc\nsteel\n"),
              "p.csv:1: the table has several columns; name that of the phases, such as p.csv:2");
    EXPECT_EQ(phases_of("a,b\n1,2\n", {"a", "b"}),
              "p.csv:1: a site has one phase, but 2 columns are named; name one");
    EXPECT_EQ(phases_of("id,phase\n1,a\n2,\n"),
              "p.csv:3: column 'phase': the field is empty; fill it");
    for (const char* text : {"", "phase\n", "# a\n"}) {
        EXPECT_EQ(phases_of(text), "p.csv: holds no phase; give one a line, one for each site");
    }
    EXPECT_EQ(phases_of(std::string_view("a\n\0", 3)).rfind("p.csv:2: holds a NUL byte", 0), 0U);
}

TEST(PhaseReader, NamesAreThoseOfSolvers) {
    EXPECT_EQ(
        phases_of("id,phase\n1,Iron bcc\n"),
        "p.csv:2: column 'phase': 'Iron bcc' is not the name of a phase; take 1 to 60 letters, "
        "digits, _ or -");
    EXPECT_EQ(phases_of("a\n" + std::string(61, 'b')),
              "p.csv:2: '" + std::string(40, 'b') +
                  "' is not the name of a phase; take 1 to 60 letters, digits, _ or -");
    EXPECT_EQ(phases_of("b\nA\n\na\n"),
              "p.csv:4: the phase a is given twice, because case does not matter; rename one");
    EXPECT_EQ(phases_of(std::string(60, 'b')), std::string(60, 'b'));
}

TEST(PhaseReader, AThousandPhasesAreRead) {
    std::string text;
    for (int k = 0; k < 1000; ++k) text += "p" + std::to_string(k) + "\n";
    EXPECT_EQ(parse_phase_table({.path = "p.csv"}, text).names.size(), 1000U);
    EXPECT_EQ(phases_of(text + "one_more\n"),
              "p.csv:1001: there are 1001 phases; give at most 1000");
}

}  // namespace
}  // namespace pcvt
