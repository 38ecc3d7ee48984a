#include "io/bytes/xml_scanner.hpp"

#include <gmock/gmock.h>

namespace pcvt {
namespace {

using Event = XmlScanner::Event;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::Pair;

using Words = std::vector<std::pair<std::string, int>>;

/// Advances to the element `name` and returns its words with their lines.
Words words_of(XmlScanner& scanner, std::string_view name) {
    while (scanner.next() != Event::kBegin || scanner.element() != name) {
    }
    Words words;
    scanner.for_each_word([&](std::string_view word, int line) { words.emplace_back(word, line); });
    return words;
}

TEST(XmlScanner, WordsOfATextCarryTheirLines) {
    XmlScanner scanner("grid.vtu", "<a>\n<b> 1 2\r\n\n\t3\n</b>\n<c>4</c></a>");
    EXPECT_THAT(words_of(scanner, "b"), ElementsAre(Pair("1", 2), Pair("2", 2), Pair("3", 4)));
    EXPECT_EQ(scanner.element(), "b");
    EXPECT_THAT(words_of(scanner, "c"), ElementsAre(Pair("4", 6)));
    EXPECT_EQ(scanner.next(), Event::kEnd);
    EXPECT_EQ(scanner.next(), Event::kNothing);
}

TEST(XmlScanner, WordsOfElementsInsideAreSkipped) {
    XmlScanner scanner("grid.vtu", "<a>1\n<b>8<c>9</c>8</b>\n2<d/>3</a>");
    EXPECT_THAT(words_of(scanner, "a"), ElementsAre(Pair("1", 1), Pair("2", 3), Pair("3", 3)));
    EXPECT_EQ(scanner.next(), Event::kNothing);
}

TEST(XmlScanner, AnElementWithoutTextHasNoWords) {
    XmlScanner scanner("grid.vtu", "<a>1<b/><c> \n </c></a>");
    EXPECT_THAT(words_of(scanner, "b"), IsEmpty());
    EXPECT_THAT(words_of(scanner, "c"), IsEmpty());
}

}  // namespace
}  // namespace pcvt
