#include "io/run_files/table_hints.hpp"

#include <gmock/gmock.h>

#include "io/run_files/site_reader.hpp"

namespace pcvt {
namespace {

using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::StartsWith;

std::string hinted_fault(const std::string& text) {
    try {
        parse_sites<2>({.path = "a.txt"}, text);
    } catch (const BadFile& fault) {
        return fault.what();
    }
    return "";
}

TEST(TableHints, ListsOfAtomsSayHowTheyBecomeATable) {
    const std::string box = ", and give the sides of the box as the period";
    EXPECT_THAT(hinted_fault("ITEM: TIMESTEP\n0\n"), StartsWith("a.txt:1: a LAMMPS dump; keep "));
    const std::string data =
        "a LAMMPS data file; keep only the lines below Atoms, name the columns "
        "of the coordinates, such as a.txt:3,4" +
        box;
    EXPECT_EQ(hinted_fault("LAMMPS data file via write_data\n\n2 atoms\n"), "a.txt:1: " + data);
    EXPECT_EQ(hinted_fault("# made by hand\n\n 2   atoms\n"), "a.txt:3: " + data);
    const std::string xyz =
        "a.txt:1: an XYZ file; leave out its first two lines, name the columns "
        "of the coordinates, such as a.txt:2,3" +
        box;
    EXPECT_EQ(hinted_fault("2\nLattice=\"1 0 0\" Properties=species:S:1:pos:R:3\n"), xyz);
    EXPECT_EQ(hinted_fault("2\nwater\nO 0 0 0\nH 1 0 0\n"), xyz);
    // Other files whose first line is a number.
    EXPECT_EQ(parse_sites<2>({.path = "a.txt"}, "2\nx y\n0 0\n1 1\n").lines.size(), 2U);
    EXPECT_THAT(hinted_fault("2\n0 0\n1 1\n"), HasSubstr("a site has 2 coordinates"));
}

TEST(TableHints, NearlyNumbersHaveTheirRemedy) {
    for (const char* text : {"1 234.5", "1'234,5",
                             "12\xC2\xA0"
                             "345",
                             "1\xE2\x80\xAF"
                             "234",
                             "1\xA0"
                             "234",
                             "1\xE2\x80\x99"
                             "234"}) {
        EXPECT_EQ(number_remedy(text), "; write no separators of thousands") << text;
    }
    EXPECT_EQ(number_remedy("\xE2\x88\x92"
                            "0.5"),
              "; write a hyphen as the minus sign");
    EXPECT_EQ(number_remedy("\xE2\x80\x93"
                            "0,5"),
              "; write a hyphen as the minus sign");
    EXPECT_EQ(number_remedy("0.5D+02"), "; write e before the exponent, as in 1.5e3");
    for (const char* text : {"", "x", "0,5", "1.5", "a b", "-", "nan", "1,2,3"}) {
        EXPECT_EQ(number_remedy(text), "") << text;
    }
}

TEST(TableHints, FieldsOfATableAreRefusedWithIt) {
    EXPECT_EQ(hinted_fault("0.5D+02 0.1D+01\n"),
              "a.txt:1: '0.5D+02' is not a number; write e before the exponent, as in 1.5e3");
    EXPECT_EQ(hinted_fault("x;y\n1 234,5;1\n"),
              "a.txt:2: column 'x': '1 234,5' is not a number; write no separators of thousands");
    EXPECT_THAT(hinted_fault("x,y\n\xE2\x88\x92"
                             "1,1\n"),
                EndsWith("write a hyphen as the minus sign"));
}

TEST(TableHints, ARowOfUnitsBelowTheHeaderIsNamed) {
    EXPECT_EQ(hinted_fault("id,x,y\n-,um,um\n1,2,3\n"),
              "a.txt:2: column 'x': 'um' is not a number; remove the row, or put units in brackets "
              "behind the names of the columns");
    EXPECT_THAT(hinted_fault("id,x,y\n1,2,3\n-,um,um\n"), HasSubstr("write a decimal such as"));
    EXPECT_THAT(hinted_fault("id,x,y\n1,um,3\n"), HasSubstr("write a decimal such as"));
}

TEST(TableHints, AHeaderBelowATitleIsNamed) {
    const std::string hint = " (if this is a title, remove the lines above the header)";
    EXPECT_THAT(hinted_fault("Grains,,\nid,x,y\n1,2,3\n"), EndsWith("of 'Grains', ''" + hint));
    EXPECT_THAT(hinted_fault("Grains of sample A\nid,x,y\n1,2,3\n"), EndsWith(hint));
    EXPECT_THAT(hinted_fault("id,a,b\n1,2,3\n"), EndsWith("of 'id', 'a', 'b'"));
}

TEST(TableHints, SuggestedCoordinatesAreTheUsersOwnColumns) {
    EXPECT_EQ(hinted_fault("Id,Centroid X (um),Centroid Y (um)\n1,2,3\n"),
              "a.txt:1: the header has no column x; name the columns of the coordinates, "
              "'a.txt:Centroid X,Centroid Y', of 'Id', 'Centroid X', 'Centroid Y'");
    EXPECT_THAT(hinted_fault("x, um;y, um;d\n1;2;3\n"), HasSubstr("coordinates, a.txt:1,2, of"));
    EXPECT_THAT(hinted_fault("xa,xb,ya\n1,2,3\n"), HasSubstr("coordinates, a.txt:X,Y, of"));
}

}  // namespace
}  // namespace pcvt
