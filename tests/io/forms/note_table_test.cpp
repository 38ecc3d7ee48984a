#include "io/forms/note_table.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <numeric>

namespace pcvt {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::string lines_of(const NoteTable& note, int index_base) {
    std::string text;
    append_note(text, "# ", note, index_base);
    return text;
}

TEST(NoteTable, CountsItsIndicesFromTheBaseOfTheFile) {
    const NoteTable pairs{
        .word = "pair", .width = 3, .n_indices = 2, .numbers = std::vector{0, 3, 1, 2, 5, -1}};
    EXPECT_EQ(lines_of(pairs, 1), "# pair 1 4 1\n# pair 3 6 -1\n");
    EXPECT_EQ(lines_of(pairs, 0), "# pair 0 3 1\n# pair 2 5 -1\n");
}

TEST(NoteTable, WithoutAWidthIsAListOfSixteenNumbersALine) {
    std::vector<int> numbers(17);
    std::iota(numbers.begin(), numbers.end(), 0);
    EXPECT_EQ(lines_of({.word = "sites", .numbers = numbers}, 1),
              "# sites 0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15\n# sites 16\n");
    // Edges of holes are all indices, on each line.
    EXPECT_EQ(lines_of({.word = "hole a", .n_indices = 16, .numbers = numbers}, 1),
              "# hole a 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16\n# hole a 17\n");
}

TEST(NoteTable, WithoutAWordOrNumbersHasNoLines) {
    EXPECT_EQ(lines_of({.word = "pair", .width = 3}, 1), "");
    EXPECT_EQ(lines_of({.columns = "cell", .numbers = std::vector{1}}, 1), "");
}

/// The fault of a text of lines `word number number ...`; empty if there is none.
std::string fault_of(const std::string& text, std::span<NoteTable> notes) {
    LineScanner scanner("t", text);
    try {
        while (scanner.next()) {
            const std::span<const std::string_view> words = scanner.words();
            if (!take_note_line(notes, scanner, words[0], words.subspan(1), 1)) return "unknown";
        }
    } catch (const BadFile& fault) {
        return fault.what();
    }
    return {};
}

TEST(NoteTable, TakesItsLinesBack) {
    std::array notes{NoteTable{.word = "pair", .width = 3, .n_indices = 2},
                     NoteTable{.word = "sites"},
                     NoteTable{.word = "site", .width = 2, .numbers = std::vector<double>()}};
    EXPECT_EQ(fault_of("pair 1 4 1\nsites 7\nsite 0.5 1\npair 3 6 -1\nsites 8 9", notes), "");
    EXPECT_THAT(notes[0].integers(), ElementsAre(0, 3, 1, 2, 5, -1));
    EXPECT_THAT(notes[1].integers(), ElementsAre(7, 8, 9));
    EXPECT_THAT(notes[2].reals(), ElementsAre(0.5, 1));
}

TEST(NoteTable, FaultsNameTheirLine) {
    std::array notes{NoteTable{.word = "pair", .width = 3, .n_indices = 2}};
    EXPECT_EQ(fault_of("pairs 1 2 3", notes), "unknown");
    EXPECT_THAT(fault_of("pair 1 2 3\npair 1 2", notes),
                HasSubstr("t:2: pair has 3 numbers here, not 2; "));
    EXPECT_THAT(fault_of("pair 1 0 0", notes), HasSubstr("index 0 does not exist; count from 1"));
    EXPECT_THAT(fault_of("pair 1 2.5 0", notes), HasSubstr("'2.5' is not a whole number"));
    EXPECT_THAT(fault_of("pair 1 -2147483648 0", notes), HasSubstr("does not exist"));
    EXPECT_EQ(fault_of("pair 1 2 -2147483648", notes), "");
}

}  // namespace
}  // namespace pcvt
