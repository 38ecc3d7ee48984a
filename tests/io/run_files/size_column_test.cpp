#include "io/run_files/size_column.hpp"

#include <gmock/gmock.h>

#include <numbers>

#include "io/run_files/area_reader.hpp"

namespace pcvt {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

/// What a table of sizes says in a summary, or its fault.
std::string reading(const std::string& text, const std::string& prefix = "",
                    const std::vector<std::string>& columns = {}) {
    try {
        return parse_areas({.path = "g.csv", .columns = columns, .prefix = prefix}, text)
            .description;
    } catch (const BadFile& fault) {
        return fault.what();
    }
}

TEST(SizeColumn, NamesOfTheHeaderStateTheSize) {
    for (const char* name : {"Area", "AREA", "Grain Area (um^2)", "cell_area"}) {
        EXPECT_THAT(reading(std::string("id,") + name + "\n1,2\n"), StartsWith("areas of column "));
    }
    for (const char* name : {"Diameter", "ECD (um)", "EquivalentDiameters", "EqDiam", "d",
                             "Equivalent Circle Diameter [mm]", "equiv. diameter"}) {
        EXPECT_THAT(reading(std::string("id,") + name + "\n1,2\n"),
                    StartsWith("diameters of column "))
            << name;
    }
    EXPECT_EQ(reading("radius\n2\n"), "radii of column radius of g.csv");
    EXPECT_NEAR(parse_areas({.path = "g.csv"}, "radius\n2\n").areas[0], 4 * std::numbers::pi,
                1e-14);
}

TEST(SizeColumn, FilesOfOneColumnKeepTheirName) {
    EXPECT_EQ(reading("1\n2\n"), "g.csv");
    EXPECT_EQ(reading("diameter\n1\n2\n"), "g.csv");
    EXPECT_EQ(reading("1\n2\n", "diameter"), "diameters of g.csv");
    EXPECT_EQ(reading("Diameter\n1\n2\n"), "diameters of column Diameter of g.csv");
}

TEST(SizeColumn, APrefixStatesTheSizeWhereTheHeaderDoesNot) {
    EXPECT_EQ(reading("size\n1\n"),
              "g.csv:1: column 'size' may hold areas or diameters; write "
              "--areas area:g.csv or --areas diameter:g.csv");
    EXPECT_EQ(reading("size\n1\n", "area"), "areas of column size of g.csv");
    EXPECT_EQ(reading("id,size\n1,2\n", "", {"size"}),
              "g.csv:1: column 'size' may hold areas or diameters; write --areas "
              "area:g.csv:size or --areas diameter:g.csv:size");
    EXPECT_EQ(reading("id,size\n1,2\n", "diameter", {"size"}), "diameters of column size of g.csv");
    EXPECT_EQ(reading("id,Feret diameter\n1,2\n", "", {"feret diameter"}),
              "diameters of column Feret diameter of g.csv");
    EXPECT_EQ(reading("id,d\n1,2\n", "area"),
              "g.csv:1: no column is called area or diameter; name the column of sizes "
              "of 'id', 'd': --areas diameter:g.csv:d");
}

TEST(SizeColumn, ColumnsInOtherLanguagesAreSuggestedButNotGuessed) {
    const auto suggestion = [](const std::string& header) {
        const std::string fault = reading(header + "\n1;2;3\n");
        return fault.substr(fault.find("--areas"));
    };
    EXPECT_EQ(reading("Korn;Fl\xC3\xA4"
                      "che (\xC2\xB5m\xC2\xB2);Durchmesser (\xC2\xB5m)\n1;2;3\n"),
              "g.csv:1: no column is called area or diameter; name the column of sizes of 'Korn', "
              "'Fl\xC3\xA4"
              "che', 'Durchmesser': --areas area:g.csv:Fl\xC3\xA4"
              "che or --areas "
              "diameter:g.csv:Durchmesser");
    EXPECT_EQ(suggestion("grain;aire;diam\xC3\xA8tre"),
              "--areas area:g.csv:aire or --areas diameter:g.csv:diam\xC3\xA8tre");
    EXPECT_EQ(suggestion("grano;\xC3\xA1rea;di\xC3\xA1metro"),
              "--areas area:g.csv:\xC3\xA1rea or --areas diameter:g.csv:di\xC3\xA1metro");
    EXPECT_EQ(suggestion("grano;superficie;raggio medio"),
              "--areas area:g.csv:superficie or --areas 'radius:g.csv:raggio medio'");
    // In Latin-1 a terminal does not show the name; without a known word the last column counts.
    EXPECT_EQ(suggestion("Korn;Fl\xE4"
                         "che;x"),
              "--areas area:g.csv:2");
    EXPECT_EQ(suggestion("id;a;size"), "--areas area:g.csv:size or --areas diameter:g.csv:size");
    EXPECT_EQ(suggestion("id;size;size"), "--areas area:g.csv:3 or --areas diameter:g.csv:3");
    // What a message suggests is read.
    EXPECT_EQ(reading("a;Fl\xC3\xA4"
                      "che\n1;2\n",
                      "area",
                      {"Fl\xC3\xA4"
                       "che"}),
              "areas of column Fl\xC3\xA4"
              "che of g.csv");
}

TEST(SizeColumn, ContradictionsAreRefused) {
    EXPECT_EQ(reading("id,Area\n1,2\n", "diameter", {"Area"}),
              "g.csv:1: column 'Area' holds areas, but the file is given as diameters; remove "
              "diameter:");
    EXPECT_THAT(reading("diameter\n1\n", "area"), HasSubstr("remove area:"));
}

TEST(SizeColumn, SeveralSizesAreRefusedUnlessOneIsNamed) {
    const std::string table = "id,Area,ECD\n1,2,3\n";
    EXPECT_EQ(reading(table),
              "g.csv:1: both column 'Area' and column 'ECD' hold sizes; name one, "
              "such as g.csv:Area");
    EXPECT_EQ(reading(table, "diameter"), "diameters of column ECD of g.csv");
    EXPECT_EQ(reading(table, "", {"area"}), "areas of column Area of g.csv");
    EXPECT_THAT(reading(table, "", {"Area", "ECD"}), StartsWith("g.csv:1: sizes are one column"));
}

TEST(SizeColumn, VolumesAreNotForThePlane) {
    EXPECT_EQ(reading("id,Volume\n1,2\n"),
              "g.csv:1: cells in the plane have areas, not volumes; name the column of sizes "
              "of 'id', 'Volume': --areas area:g.csv:COLUMN or --areas diameter:g.csv:COLUMN");
    EXPECT_THAT(reading("volume\n2\n"), StartsWith("g.csv:1: column 'volume' holds volumes, but"));
    EXPECT_EQ(reading("id,ECD,Volumes\n1,2,3\n"), "diameters of column ECD of g.csv");
}

TEST(SizeColumn, AFeatureOfNumberZeroIsRefusedWithTheReason) {
    EXPECT_EQ(reading("Feature_ID,d\n0,0\n1,2\n"),
              "g.csv:2: column 'd': '0' is not the size of a cell, but exporters list a feature 0 "
              "without "
              "a size; remove the line");
    EXPECT_EQ(
        reading("Feature_ID,d\n1,2\n2,0\n"),
        "g.csv:3: column 'd': '0' is not the size of a cell; give a number from 1e-150 to 1e150");
}

TEST(SizeColumn, OneColumnWithDecimalCommasNeedsAHeader) {
    EXPECT_THAT(reading("0,5\n0,25\n"),
                StartsWith("g.csv:1: '0,5' is not a number; write a decimal "
                           "point, or where the comma separates"));
    EXPECT_THAT(reading("0,5\n", "", {"1"}), StartsWith("g.csv:1: '0,5' may be one number or two"));
    EXPECT_EQ(reading("Diameter (um)\n0,5\n"), "diameters of column Diameter (um) of g.csv");
    EXPECT_THAT(reading("1,2,3\n"),
                StartsWith("g.csv:1: this line has 3 words; write one area a "));
}

TEST(SizeColumn, OfVolumesTakesVolumesDiametersAndRadii) {
    const auto volumes = [](const std::string& text, const std::string& prefix = "") {
        return parse_volumes({.path = "v.csv", .prefix = prefix}, text);
    };
    EXPECT_EQ(volumes("2\n3\n").areas, Eigen::Vector2d(2, 3));
    EXPECT_EQ(volumes("Grain;Volume (um^3)\n1;2,5\n2;3\n").areas, Eigen::Vector2d(2.5, 3));
    const double pi = std::acos(-1.0);
    EXPECT_NEAR(volumes("ECD\n2\n").areas[0], pi * 8 / 6, 1e-14);
    EXPECT_NEAR(volumes("1\n", "radius").areas[0], pi * 4 / 3, 1e-14);
    try {
        volumes("area\n1\n");
        ADD_FAILURE();
    } catch (const BadFile& fault) {
        EXPECT_STREQ(fault.what(),
                     "v.csv:1: column 'area' holds areas, but cells in space have volumes; name a "
                     "column of volumes or diameters, v.csv:COLUMN");
    }
}

}  // namespace
}  // namespace pcvt
