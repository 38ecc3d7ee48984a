#include "io/run_files/area_reader.hpp"

#include <gmock/gmock.h>

#include <numbers>

namespace pcvt {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;

std::string area_fault(std::string_view text, int n_sites = 0) {
    try {
        const AreaFile file = parse_areas({.path = "a.txt"}, text);
        if (n_sites > 0) require_areas(file, n_sites);
    } catch (const BadFile& fault) {
        return fault.what();
    }
    return "";
}

std::vector<double> values(const AreaFile& file) { return {file.areas.begin(), file.areas.end()}; }

TEST(AreaReader, AreasAndTheirLinesAreRead) {
    const AreaFile file = parse_areas({.path = "a.txt"}, "# head\n0.25\n\n +1.5e1 # tail\n3#x\n");
    EXPECT_THAT(values(file), ElementsAre(0.25, 15, 3));
    EXPECT_THAT(file.lines, ElementsAre(2, 4, 5));
    EXPECT_EQ(file.name, "a.txt");
}

TEST(AreaReader, LineEndsAndMarksAreAccepted) {
    const AreaFile file = parse_areas({.path = "a.txt"},
                                      "\xEF\xBB\xBF"
                                      "1\r\n# c\r\n\t7\t\r\n0.1");
    EXPECT_THAT(values(file), ElementsAre(1, 7, 0.1));
    EXPECT_THAT(file.lines, ElementsAre(1, 3, 4));
}

TEST(AreaReader, DiametersAreThoseOfCircles) {
    const AreaFile file = parse_areas({.path = "a.txt"}, "# sizes\ndiameter # of circles\r\n2\n4");
    EXPECT_NEAR(file.areas[0], std::numbers::pi, 1e-15);
    EXPECT_NEAR(file.areas[1], 4 * std::numbers::pi, 4e-15);
    EXPECT_THAT(file.lines, ElementsAre(3, 4));
}

TEST(AreaReader, EachFaultNamesItsLineAndARemedy) {
    EXPECT_THAT(area_fault("1\n-2\n"),
                StartsWith("a.txt:2: '-2' is not the size of a cell; give a "));
    for (const char* zero : {"0", "-0", "0.0", "0e9"}) {
        EXPECT_THAT(area_fault("1\n\n" + std::string(zero)), StartsWith("a.txt:3: ")) << zero;
    }
    for (const char* word : {"nan", "inf", "-inf", "NaN", "infinity"}) {
        EXPECT_THAT(area_fault("1\n" + std::string(word) + "\n"), StartsWith("a.txt:2: ")) << word;
    }
    EXPECT_THAT(area_fault("1e400"), StartsWith("a.txt:1: '1e400' is beyond the range"));
    EXPECT_THAT(area_fault("1e160"), StartsWith("a.txt:1: '1e160' is not the size of a cell; "));
    EXPECT_THAT(area_fault("1\n1e-160"),
                StartsWith("a.txt:2: '1e-160' is not the size of a cell; "));
    EXPECT_THAT(area_fault("1,5"), StartsWith("a.txt:1: '1,5' is not a number; "));
    EXPECT_THAT(area_fault("1 2"), StartsWith("a.txt:1: this line has 2 words; write one area"));
}

TEST(AreaReader, AHeaderComesFirstAndOnce) {
    EXPECT_THAT(area_fault("1\ndiameter\n2"), StartsWith("a.txt:2: 'diameter' is not a number"));
    EXPECT_THAT(area_fault("diameter\ndiameter\n2"), StartsWith("a.txt:2: 'diameter' is not"));
    EXPECT_THAT(area_fault("diameter 3\n"), StartsWith("a.txt:1: this line has 2 words"));
}

TEST(AreaReader, EmptyFilesAreRefused) {
    const std::string words = "a.txt: holds no area; give one a line, one for each site";
    for (const char* text : {"", "\n\n", "# 1\n", "diameter\n", "\xEF\xBB\xBF"}) {
        EXPECT_EQ(area_fault(text), words) << text;
    }
}

TEST(AreaReader, BinaryFilesAreRefusedWithALine) {
    EXPECT_THAT(area_fault(std::string_view("1\n\0", 3)), StartsWith("a.txt:2: holds a NUL byte"));
    EXPECT_THAT(area_fault(std::string_view("\xFF\xFE"
                                            "1\0",
                                            4)),
                HasSubstr("UTF-16"));
    EXPECT_THAT(area_fault("\x89PNG\r\n\x1A\n"), StartsWith("a.txt:1: "));
}

TEST(AreaReader, TheCountIsThatOfTheSites) {
    EXPECT_EQ(area_fault("1\n2\n3", 3), "");
    EXPECT_EQ(area_fault("1\n\n2 # last\n#\n", 3),
              "a.txt:3: the last of 2 areas, but there are 3 sites; give one area for each site");
    EXPECT_EQ(area_fault("1\n2\n#\n3", 2),
              "a.txt:4: area 3, but there are 2 sites; give one area for each site");
    EXPECT_THAT(area_fault("1\n2\n3\n4\n5", 2), StartsWith("a.txt:3: area 3, but"));
}

TEST(AreaReader, AnAreaFarBelowTheMeanIsRefused) {
    EXPECT_EQ(area_fault("1\n1.1e-6\n1", 3), "");
    // Below 1e-6 of the largest, but not of the mean.
    EXPECT_EQ(area_fault("1\n5e-7\n1e-3", 3), "");
    EXPECT_EQ(area_fault("1\n1\n6e-7", 3),
              "a.txt:3: the area is below 1e-6 of the mean; give a larger one");
    // Areas whose sum is beyond the range of numbers are relative all the same.
    EXPECT_EQ(area_fault("1e150\n1e150\n", 2), "");
    EXPECT_EQ(area_fault("1e150\n1e-150\n", 2),
              "a.txt:2: the area is below 1e-6 of the mean; give a larger one");
}

}  // namespace
}  // namespace pcvt
