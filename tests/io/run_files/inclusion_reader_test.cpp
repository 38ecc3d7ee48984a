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

/// The first shape of a text, a circle: x, y, r.
std::array<double, 3> first_circle(std::string_view text) {
    const InclusionFile file = parse_inclusions("i.txt", text);
    const auto& circle = std::get<plane::Circle>(file.inclusions.at(0).shape);
    EXPECT_THAT(file.tags, ElementsAre("steel"));
    return {circle.centre.x(), circle.centre.y(), circle.radius};
}

TEST(InclusionReader, SeparatorsAreThoseOfTables) {
    for (const char* text :
         {"circle steel 0.5, 0.25, 0.125", "circle,steel,0.5,0.25,0.125",
          "circle\tsteel\t0.5\t0.25\t0.125\t", "circle, steel, 0.5, 0.25, 0.125",
          "circle steel 0.5,0.25,0.125", "circle , steel , 0.5 , 0.25 , 0.125",
          "circle;steel;0.5;0.25;0.125", "circle;steel;0,5;0,25;0,125",
          "circle\tsteel\t0,5\t0,25\t0,125",
          "\357\273\277Circle;\"steel\";\"0,5\";0,25;0,125;;;\r\n",
          "sep=;\nCIRCLE;steel;0,5;0,25;0,125\n", "\"circle\",\"steel\",\"0.5\",\"0.25\",\"0.125\"",
          "circle steel 0.5 0.25 0.125,", "shape;tag;x;y;r\ncircle;steel;0,5;0,25;0,125\n",
          "# a\nshape,tag,x,y,r\n\ncircle,steel,0.5,0.25,0.125\n"}) {
        EXPECT_THAT(first_circle(text), ElementsAre(0.5, 0.25, 0.125)) << text;
    }
    const InclusionFile file = parse_inclusions(
        "i.csv", "shape;tag;x;y;r;;;\r\ncircle;a;0,5;0,5;0,2;;;\r\npolygon;b;0;0;0,5;0;0;0,5\r\n");
    EXPECT_EQ(file.inclusions[0].line, 2);
    EXPECT_EQ(
        parse_inclusions("i.csv", "circle;a;0;0;1\n;;;;\ncircle;a;2;2;1\n;\n").inclusions[1].line,
        3);
    EXPECT_THAT(std::get<plane::Polygon>(file.inclusions[1].shape),
                ElementsAre(plane::Vec2(0, 0), plane::Vec2(0.5, 0), plane::Vec2(0, 0.5)));
    EXPECT_THAT(std::get<plane::Polygon>(
                    parse_inclusions("i.txt", "polygon b 0,0 5,0 0,5\n").inclusions[0].shape),
                ElementsAre(plane::Vec2(0, 0), plane::Vec2(5, 0), plane::Vec2(0, 5)));
}

TEST(InclusionReader, CommasThatMayBeDecimalMarksAreRefused) {
    EXPECT_EQ(
        inclusion_fault("circle steel 0,5 0,25 0,125\n"),
        "i.txt:1: '0,5' may be one number or two; write decimal points, or semicolons between "
        "fields");
    EXPECT_EQ(
        inclusion_fault("circle a 1 2 3\npolygon b 0,0 1,0 1,1 0,1 2,3 4,5\n"),
        "i.txt:2: '0,0' may be one number or two; write decimal points, or semicolons between "
        "fields");
    EXPECT_THAT(inclusion_fault("circle;a;0,5;0.5;0,2\n"),
                StartsWith("i.txt:1: '0.5' has a decimal point, "));
    EXPECT_THAT(inclusion_fault("circle;a;1,234;1,234;1,234\n"),
                HasSubstr("or stand between thousands"));
    EXPECT_THAT(inclusion_fault("circle,a,1,,3\n"), StartsWith("i.txt:1: a field is empty"));
    EXPECT_THAT(inclusion_fault("circle;a;1;;3\n"), StartsWith("i.txt:1: the field is empty"));
    EXPECT_THAT(inclusion_fault("square;a;b\n"), HasSubstr("holds no inclusion"));
    EXPECT_THAT(inclusion_fault("shape tag x\nsquare a b\n"),
                StartsWith("i.txt:2: 'square' is not a shape"));
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
