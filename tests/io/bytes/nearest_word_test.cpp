#include "io/bytes/nearest_word.hpp"

#include <gmock/gmock.h>

namespace pcvt {
namespace {

TEST(NearestWord, DistanceCountsInsertionsDeletionsReplacementsAndSwaps) {
    EXPECT_EQ(edit_distance("", ""), 0);
    EXPECT_EQ(edit_distance("", "abc"), 3);
    EXPECT_EQ(edit_distance("abc", ""), 3);
    EXPECT_EQ(edit_distance("abc", "abd"), 1);
    EXPECT_EQ(edit_distance("abc", "ac"), 1);
    EXPECT_EQ(edit_distance("abcd", "abdc"), 1);
    EXPECT_EQ(edit_distance("kitten", "sitting"), 3);
}

TEST(NearestWord, FindsWordsWithinTwoEdits) {
    const std::vector<std::string> words = {"lbfgs", "lloyd", "newton"};
    EXPECT_EQ(nearest_word("lbgfs", words), "lbfgs");
    EXPECT_EQ(nearest_word("loyd", words), "lloyd");
    EXPECT_EQ(nearest_word("newtno", words), "newton");
    EXPECT_EQ(nearest_word("magic", words), "");
    EXPECT_EQ(nearest_word("", words), "");
}

TEST(NearestWord, ShortWordsNeedFewerEdits) {
    EXPECT_EQ(nearest_word("bx", {"box", "whole"}), "box");
    EXPECT_EQ(nearest_word("x", {"box", "whole"}), "");
    EXPECT_EQ(nearest_word("n", {"o"}), "");
}

TEST(NearestWord, WordsThatAreEquallyNearAreNotChosenBetween) {
    EXPECT_EQ(nearest_word("fig12", {"fig10", "fig11", "fig7"}), "");
    EXPECT_EQ(nearest_word("site", {"size", "sites"}), "sites");
    EXPECT_EQ(nearest_word("fig111", {"fig10", "fig11", "fig7"}), "fig11");
}

TEST(NearestWord, TheOnlyWordWithThisBeginningIsMeant) {
    const std::vector<std::string> words = {"tolerance", "density", "density-range"};
    EXPECT_EQ(nearest_word("tol", words), "tolerance");
    EXPECT_EQ(nearest_word("to", words), "");
    EXPECT_EQ(nearest_word("den", words), "");
}

}  // namespace
}  // namespace pcvt
