#include "plugin/cli/terminal/status_line.hpp"

#include <gtest/gtest.h>

namespace pcvt::cli {
namespace {

TEST(FitLine, LeavesOutThePartsThatDoNotFit) {
    EXPECT_EQ(fit_line({"half done", "12 s left", "more"}, 80), "half done  12 s left  more");
    EXPECT_EQ(fit_line({"half done", "12 s left", "more"}, 20), "half done  12 s left");
    EXPECT_EQ(fit_line({"half done", "12 s left", "more"}, 19), "half done  more");
    EXPECT_EQ(fit_line({"half done", "12 s left"}, 4), "half");
    EXPECT_EQ(fit_line({"half done", "12 s left"}, 0), "");
    EXPECT_EQ(fit_line({}, 80), "");
}

TEST(FitLine, CutsBetweenCharacters) {
    EXPECT_EQ(fit_line({"h\xC3\xA9xagone"}, 2), "h\xC3\xA9");
    EXPECT_EQ(fit_line({"\xE5\x85\xAD\xE8\xA7\x92"}, 3), "\xE5\x85\xAD");
    EXPECT_EQ(columns_of("h\xC3\xA9 \xE5\x85\xAD"), 5);
}

TEST(FitLine, ShowsControlCharactersAsQuestionMarks) {
    EXPECT_EQ(fit_line({"a\nb\x1B[2J\x7F"}, 80), "a?b?[2J?");
}

}  // namespace
}  // namespace pcvt::cli
