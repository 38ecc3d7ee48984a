#include "io/run_files/inclusion_reader.hpp"

#include <gmock/gmock.h>

#include "io/bytes/bad_file.hpp"

namespace pcvt {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;

std::string inclusion_fault(std::string_view text) {
    try {
        parse_inclusions("i.txt", text);
    } catch (const BadFile& fault) {
        return fault.what();
    }
    return "";
}

TEST(InclusionReader, ShapesTagsAndLinesAreRead) {
    const InclusionFile file = parse_inclusions(
        "i.txt",
        "# head\ncircle glass 0.5 -0.25 1e-1\r\n\nellipse carbon 1 2 0.3 0.2 45 # tail\n"
        "polygon glass 0 0 1 0 0.5 1\n");
    EXPECT_THAT(file.tags, ElementsAre("glass", "carbon"));
    ASSERT_EQ(file.inclusions.size(), 3U);
    const auto& circle = std::get<plane::Circle>(file.inclusions[0].shape);
    EXPECT_EQ(circle.centre, plane::Vec2(0.5, -0.25));
    EXPECT_EQ(circle.radius, 0.1);
    const auto& ellipse = std::get<plane::Ellipse>(file.inclusions[1].shape);
    EXPECT_EQ(ellipse.centre, plane::Vec2(1, 2));
    EXPECT_THAT((std::array{ellipse.a, ellipse.b, ellipse.degrees}), ElementsAre(0.3, 0.2, 45));
    EXPECT_THAT(std::get<plane::Polygon>(file.inclusions[2].shape),
                ElementsAre(plane::Vec2(0, 0), plane::Vec2(1, 0), plane::Vec2(0.5, 1)));
    std::vector<int> tags;
    std::vector<int> lines;
    for (const plane::Inclusion& inclusion : file.inclusions) {
        tags.push_back(inclusion.tag);
        lines.push_back(inclusion.line);
    }
    EXPECT_THAT(tags, ElementsAre(1, 2, 1));
    EXPECT_THAT(lines, ElementsAre(2, 4, 5));
}

TEST(InclusionReader, EachFaultNamesItsLineAndARemedy) {
    EXPECT_THAT(inclusion_fault("# a\nsquare a 1 2 3\n"),
                StartsWith("i.txt:2: 'square' is not a shape; write \"circle TAG x y r\""));
    EXPECT_THAT(inclusion_fault("circle\n"), StartsWith("i.txt:1: a tag is missing; write"));
    EXPECT_EQ(inclusion_fault("circle a 1 2\n"),
              "i.txt:1: a circle does not take 2 numbers; write \"circle TAG x y r\"");
    EXPECT_THAT(inclusion_fault("ellipse a 1 2 3 4 5 6\n"),
                HasSubstr("an ellipse does not take 6 numbers"));
    for (const char* numbers : {"", "0 0 1 0", "0 0 1 0 1", "0 0 1 0 1 1 2"}) {
        EXPECT_THAT(inclusion_fault("polygon a " + std::string(numbers)),
                    HasSubstr("write \"polygon TAG x1 y1 x2 y2 x3 y3 ...\""));
    }
    EXPECT_THAT(inclusion_fault("circle a 1 2 r\n"), StartsWith("i.txt:1: 'r' is not a number"));
    EXPECT_THAT(inclusion_fault("circle a! 1 2 3\n"), StartsWith("i.txt:1: the tag 'a!': "));
    EXPECT_THAT(inclusion_fault("circle Matrix 1 2 3\n"),
                StartsWith("i.txt:1: the tag 'Matrix': "));
    EXPECT_THAT(inclusion_fault("circle a 1 2 3\ncircle A 1 2 3\n"),
                HasSubstr("case does not matter"));
    EXPECT_THAT(inclusion_fault("# nothing\n"), StartsWith("i.txt: holds no inclusion; write"));
    EXPECT_THAT(inclusion_fault(std::string_view("circle\0a", 8)), HasSubstr("binary"));
}

TEST(InclusionReader, FibresHaveAFractionANumberAndPerhapsAGap) {
    const plane::RandomCircles plain = parse_fibres("0.5,30");
    EXPECT_EQ(plain.fraction, 0.5);
    EXPECT_EQ(plain.n, 30);
    EXPECT_EQ(plain.gap, plane::RandomCircles{}.gap);
    EXPECT_EQ(parse_fibres("0.5,30,0.015").gap, 0.015);
    for (const char* const text : {"", "0.5", "0.5,x", "0.5,30,", "0.5,30,0.1,1"}) {
        EXPECT_THROW(parse_fibres(text), InvalidInput) << text;
    }
}

}  // namespace
}  // namespace pcvt
