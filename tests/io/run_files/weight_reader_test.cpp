#include "io/run_files/weight_reader.hpp"

#include <gmock/gmock.h>

#include <string>
#include <vector>

namespace pcvt {
namespace {

using ::testing::ElementsAre;

std::vector<double> weights_of(const std::string& text, const TableName& name = {"w.csv"}) {
    const WeightFile file = parse_weights(name, text);
    return {file.weights.begin(), file.weights.end()};
}

std::string weight_fault(std::string_view text, const TableName& name = {"w.csv"},
                         int n_sites = 0) {
    try {
        const WeightFile file = parse_weights(name, text);
        if (n_sites > 0) require_weights(file, n_sites);
    } catch (const BadFile& fault) {
        return fault.what();
    }
    return "";
}

TableName with_column(const std::string& column, const std::string& prefix = "") {
    return {.path = "w.csv", .columns = {column}, .prefix = prefix};
}

TEST(WeightReader, NumbersWithoutAHeaderAreWeightsOfAnySign) {
    EXPECT_THAT(weights_of("0.25\n\n-3 # tail\r\n+0\n1e100"), ElementsAre(0.25, -3, 0, 1e100));
    const WeightFile file = parse_weights({"w.csv"}, "# head\n1\n\n2\n");
    EXPECT_THAT(file.lines, ElementsAre(2, 4));
    EXPECT_EQ(file.description, "lengths squared of w.csv");
    EXPECT_EQ(file.name, "w.csv");
}

TEST(WeightReader, TheHeaderDecidesAboutWeightsRadiiAndDiameters) {
    for (const char* header : {"weight", "Weights", "WEIGHT", "weight (um^2)"}) {
        EXPECT_THAT(weights_of(std::string(header) + "\n2\n-3\n"), ElementsAre(2, -3)) << header;
    }
    for (const char* header : {"radius", "R", "Radii", "Radius [um]", "equivalent radius"}) {
        EXPECT_THAT(weights_of(std::string(header) + "\n2\n0\n"), ElementsAre(4, 0)) << header;
    }
    for (const char* header : {"diameter", "D", "ECD", "Diam", "Diameter (mm)"}) {
        EXPECT_THAT(weights_of(std::string(header) + "\n2\n3\n"), ElementsAre(1, 2.25)) << header;
    }
}

TEST(WeightReader, ThePrefixDecidesAlsoWithoutAHeader) {
    EXPECT_THAT(weights_of("2\n3\n", {"w.csv", {}, "radius"}), ElementsAre(4, 9));
    EXPECT_THAT(weights_of("2\n3\n", {"w.csv", {}, "diameter"}), ElementsAre(1, 2.25));
    EXPECT_THAT(weights_of("2\n3\n", {"w.csv", {}, "weight"}), ElementsAre(2, 3));
    EXPECT_THAT(weights_of("size\n2\n", {"w.csv", {}, "radius"}), ElementsAre(4));
    EXPECT_THAT(weights_of("id;size\n1;0,5\n", with_column("size", "radius")), ElementsAre(0.25));
    EXPECT_THAT(weights_of("7 2\n8 3\n", with_column("2", "diameter")), ElementsAre(1, 2.25));
}

TEST(WeightReader, NamesOfTablesHavePrefixesAndColumns) {
    for (const char* prefix : {"weight", "radius", "diameter"}) {
        const TableName name = weight_table(std::string(prefix) + ":none.csv:R1");
        EXPECT_EQ(name.prefix, prefix);
        EXPECT_EQ(name.path, "none.csv");
        EXPECT_THAT(name.columns, ElementsAre("R1"));
    }
    EXPECT_EQ(weight_table("none.csv").prefix, "");
    EXPECT_EQ(weight_table("area:none.csv").path, "area");
}

TEST(WeightReader, AmongSeveralColumnsTheOneOfWeightsOrRadiiIsTaken) {
    EXPECT_THAT(weights_of("x,y,weight\n1,2,3\n"), ElementsAre(3));
    EXPECT_THAT(weights_of("x,y,radius,weight\n1,2,3,5\n"), ElementsAre(5));
    EXPECT_THAT(weights_of("x,y,R (um),area\n1,2,3,5\n"), ElementsAre(9));
    EXPECT_THAT(weights_of("id,Diameter,phase\n1,2,a\n"), ElementsAre(1));
    EXPECT_THAT(weights_of("x,y,radius,weight\n1,2,3,5\n", with_column("radius")), ElementsAre(9));
    EXPECT_THAT(weights_of("1 2 3\n4 5 6\n", with_column("3")), ElementsAre(3, 6));
}

TEST(WeightReader, TheSummaryStatesWhatTheFileHolds) {
    const auto description = [](const std::string& text, const TableName& name = {"w.csv"}) {
        return parse_weights(name, text).description;
    };
    EXPECT_EQ(description("x,R (\xC2\xB5m)\n1,2\n"), "squared radii of column R (um) of w.csv");
    EXPECT_EQ(description("d\n1\n"), "squared halves of diameters of column d of w.csv");
    EXPECT_EQ(description("weight\n1\n"), "lengths squared of column weight of w.csv");
    EXPECT_EQ(description("1\n", {"w.csv", {}, "radius"}), "squared radii of w.csv");
    EXPECT_EQ(description("1 2\n", with_column("2")), "lengths squared of column 2 of w.csv");
}

TEST(WeightReader, WrongNumbersAreRefusedWithLineAndColumn) {
    EXPECT_EQ(weight_fault("radius\n1\n-0.5\n"),
              "w.csv:3: '-0.5' is negative; give a length from 0 on");
    EXPECT_EQ(weight_fault("x,radius\n1,2\n1,-2\n"),
              "w.csv:3: column 'radius': '-2' is negative; give a length from 0 on");
    for (const char* large : {"1e150", "-1e150", "1e200"}) {
        EXPECT_EQ(weight_fault("1\n" + std::string(large)),
                  "w.csv:2: '" + std::string(large) + "' is too large; give a number below 1e150");
    }
    EXPECT_EQ(weight_fault("1\nx\n"),
              "w.csv:2: 'x' is not a number; write a decimal such as -1.5e3");
    EXPECT_EQ(weight_fault("1\n2 3\n"), "w.csv:2: this line has 2 words; write one weight a line");
    EXPECT_EQ(
        weight_fault("1 2\n3\n", with_column("2")),
        "w.csv:2: the row has 1 field with blanks between them, but the first row has 2; give "
        "one field for each column");
    EXPECT_EQ(weight_fault("x,weight\n1,\n"),
              "w.csv:2: column 'weight': the field is empty; give a number");
    for (const char* word : {"nan", "inf", "-Infinity"}) {
        EXPECT_EQ(
            weight_fault("1\n" + std::string(word)),
            "w.csv:2: '" + std::string(word) + "' is not a finite number; give finite numbers");
    }
}

TEST(WeightReader, UnclearColumnsAreRefusedWithTheNameToWrite) {
    EXPECT_EQ(weight_fault("size\n1\n"),
              "w.csv:1: column 'size' could hold weights, radii or diameters; say which, such as "
              "radius:w.csv:size");
    EXPECT_EQ(weight_fault("x,area\n1,2\n", with_column("area")),
              "w.csv:1: column 'area' could hold weights, radii or diameters; say which, such as "
              "radius:w.csv:area");
    EXPECT_EQ(weight_fault("1 2 3\n"),
              "w.csv:1: the table has several columns; name that of the weights, such as w.csv:3");
    EXPECT_EQ(weight_fault("1 2\n"),
              "w.csv:1: the table has several columns; name that of the weights, such as w.csv:2");
    EXPECT_EQ(weight_fault("x,y\n1,2\n"),
              "w.csv:1: none of the columns 'x', 'y' states weights or radii; name one, such as "
              "radius:w.csv:y");
    EXPECT_EQ(weight_fault("radius,diameter\n1,2\n"),
              "w.csv:1: several columns may hold the radii; name one, such as w.csv:diameter");
    EXPECT_EQ(weight_fault("a,b\n1,2\n", {"w.csv", {"a", "b"}}),
              "w.csv:1: a site has one weight, but 2 columns are named; name one");
    EXPECT_EQ(weight_fault("a,b\n1,2\n", with_column("c")),
              "w.csv:1: there is no column 'c'; take one of 'a', 'b'");
}

TEST(WeightReader, APrefixThatContradictsTheHeaderIsRefused) {
    EXPECT_EQ(weight_fault("diameter\n1\n", {"w.csv", {}, "radius"}),
              "w.csv:1: column 'diameter' holds diameters, but the file is given as radii; remove "
              "radius:");
    EXPECT_EQ(weight_fault("weight\n1\n", {"w.csv", {}, "radius"}),
              "w.csv:1: column 'weight' holds weights, but the file is given as radii; remove "
              "radius:");
    EXPECT_EQ(weight_fault("radius\n1\n", {"w.csv", {}, "weight"}),
              "w.csv:1: column 'radius' holds radii, but the file is given as weights; remove "
              "weight:");
    EXPECT_EQ(weight_fault("area\n1\n", {"w.csv", {}, "weight"}), "");
}

TEST(WeightReader, APrefixChoosesAmongColumns) {
    EXPECT_THAT(weights_of("x,radius,weight\n1,2,9\n", {"w.csv", {}, "radius"}), ElementsAre(4));
    EXPECT_THAT(weights_of("x,radius,diameter\n1,2,6\n", {"w.csv", {}, "diameter"}),
                ElementsAre(9));
}

TEST(WeightReader, EmptyFilesAreRefused) {
    for (const char* text : {"", "# 1\n", "weight\n", "\xEF\xBB\xBF"}) {
        EXPECT_EQ(weight_fault(text), "w.csv: holds no weight; give one a line, one for each site")
            << text;
    }
    EXPECT_EQ(weight_fault(std::string_view("1\n\0", 3)).rfind("w.csv:2: holds a NUL byte", 0), 0U);
}

TEST(WeightReader, TheCountIsThatOfTheSites) {
    EXPECT_EQ(weight_fault("1\n2\n3", {"w.csv"}, 3), "");
    EXPECT_EQ(
        weight_fault("1\n\n2\n", {"w.csv"}, 3),
        "w.csv:3: the last of 2 weights, but there are 3 sites; give one weight for each site");
    EXPECT_EQ(weight_fault("1\n2\n#\n3", {"w.csv"}, 2),
              "w.csv:4: weight 3, but there are 2 sites; give one weight for each site");
}

}  // namespace
}  // namespace pcvt
