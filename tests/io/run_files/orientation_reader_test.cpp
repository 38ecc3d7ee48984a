#include "io/run_files/orientation_reader.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <string>
#include <vector>

#include "io/bytes/bad_file.hpp"

namespace pcvt {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

/// The angles of the first row of a table, or its fault.
std::string first_angles(const std::string& text, const std::string& prefix = "",
                         const std::vector<std::string>& columns = {}) {
    try {
        const BungeAngles angles =
            parse_orientations({.path = "o.csv", .columns = columns, .prefix = prefix}, text)
                .angles.front();
        const auto figure = [](double x) { return std::to_string(std::lround(x)); };
        return figure(angles.phi1) + " " + figure(angles.Phi) + " " + figure(angles.phi2);
    } catch (const BadFile& fault) {
        return fault.what();
    }
}

TEST(OrientationReader, NamesOfOtherProgramsAreKnown) {
    for (const char* header :
         {"phi1,Phi,phi2", "PHI1,PHI,PHI2", "Euler1,Euler2,Euler3", "EULER 1,EULER 2,EULER 3",
          "EulerAngles_0,EulerAngles_1,EulerAngles_2",
          "AvgEulerAngles_0,AvgEulerAngles_1,AvgEulerAngles_2", "phi1_mean,Phi_mean,phi2_mean",
          "EulerMean_phi1,EulerMean_Phi,EulerMean_phi2", "\xCF\x86\x31,\xCE\xA6,\xCF\x86\x32",
          "Mean Orientation phi1 (deg),Mean Orientation Phi (deg),Mean Orientation phi2 (deg)",
          "phi1_deg,Phi_deg,phi2_deg", "Euler1 (\xC2\xB0),Euler2 (\xC2\xB0),Euler3 (\xC2\xB0)"}) {
        EXPECT_EQ(first_angles("id," + std::string(header) + ",phase\n1,10,20,30,a\n"), "10 20 30")
            << header;
    }
    EXPECT_EQ(first_angles("phi2,phi1,Phi\n30,10,20\n"), "10 20 30");
}

TEST(OrientationReader, NamedColumnsAreTakenInTheirOrder) {
    EXPECT_EQ(first_angles("a,b,c,d\n1,2,3,4\n", "", {"d", "a", "b"}), "4 1 2");
    EXPECT_EQ(first_angles("1,2,3,4\n", "", {"4", "1", "2"}), "4 1 2");
    EXPECT_EQ(first_angles("a,b,c\n1,2,3\n", "rad", {"a", "b", "c"}), "57 115 172");
    EXPECT_THAT(first_angles("a,b,c\n1,2,3\n", "", {"a", "b"}),
                StartsWith("o.csv:1: an orientation has 3 angles, 2 columns are named; write "));
}

TEST(OrientationReader, TheHeaderStatesTheUnit) {
    EXPECT_EQ(first_angles("phi1 (rad),Phi (rad),phi2 (rad)\n1,2,3\n"), "57 115 172");
    EXPECT_EQ(first_angles("phi1_rad,Phi_rad,phi2_rad\n1,2,3\n"), "57 115 172");
    EXPECT_THAT(first_angles("phi1 (rad),Phi (rad),phi2 (rad)\n1,2,3\n", "deg"),
                StartsWith("o.csv:1: the header states another unit of the angles than deg:; "));
    EXPECT_THAT(first_angles("phi1 (rad),Phi (deg),phi2 (rad)\n1,2,3\n"),
                StartsWith("o.csv:1: column 'phi1' and column 'Phi' do not have the same unit; "));
    EXPECT_THAT(first_angles("phi1 (um),Phi (um),phi2 (um)\n1,2,3\n"),
                StartsWith("o.csv:1: column 'phi1' has the unit 'um'; give angles in deg or rad"));
    std::string many = "phi1 (deg),Phi (deg),phi2 (deg)\n";
    for (int k = 0; k < 20; ++k) many += "1,2,3\n";
    EXPECT_EQ(first_angles(many), "1 2 3");
    many.replace(0, many.find('\n'), "phi1,Phi,phi2");
    EXPECT_THAT(first_angles(many), HasSubstr("look like radians"));
}

TEST(OrientationReader, HeadersWithoutThreeAnglesOrWithSixAreRefused) {
    EXPECT_EQ(first_angles("phi1,Phi\n1,2\n"),
              "o.csv:1: the header has no columns phi1, Phi and "
              "phi2; name the columns, o.csv:COLUMN,COLUMN,COLUMN, of 'phi1', 'Phi'");
    EXPECT_EQ(
        first_angles("Euler1,Euler2,Euler3,phi1,Phi,phi2\n1,2,3,4,5,6\n"),
        "o.csv:1: both column 'Euler1' and column 'phi1' begin three angles; name three, such "
        "as o.csv:Euler1,Euler2,Euler3");
    EXPECT_THAT(first_angles("1 2 3 4\n"), StartsWith("o.csv:1: an orientation has 3 angles, this "
                                                      "line has 4; write \"phi1 Phi phi2\""));
    EXPECT_THAT(first_angles("phi1,Phi,phi2\n1,2,400\n"), StartsWith("o.csv:2: "));
}

/// The weights and the source of a table, or its fault.
std::string weights_of(const std::string& text, const std::vector<std::string>& columns = {},
                       const std::string& prefix = "") {
    try {
        const OrientationTable table =
            parse_orientations({.path = "o.csv", .columns = columns, .prefix = prefix}, text);
        std::string weights;
        for (const double w : table.weights) weights += std::to_string(std::lround(w)) + " ";
        return weights + "of " + table.source;
    } catch (const BadFile& fault) {
        return fault.what();
    }
}

TEST(OrientationReader, WeightsAreAFourthColumnOrOneOfTheirName) {
    const std::string rows = "10,20,30,2\n40,50,60,0\n";
    EXPECT_EQ(weights_of("phi1,Phi,phi2,Weight\n" + rows), "2 0 of o.csv by column 'Weight'");
    EXPECT_EQ(weights_of("phi1,Phi,phi2,Volume_Fraction\n" + rows),
              "2 0 of o.csv by column 'Volume_Fraction'");
    EXPECT_EQ(weights_of("phi1,Phi,phi2,area\n" + rows), "of o.csv");
    EXPECT_EQ(weights_of("phi1,Phi,phi2,area\n" + rows, {"phi1", "Phi", "phi2", "area"}),
              "2 0 of o.csv by column 'area'");
    EXPECT_EQ(weights_of("phi1,Phi,phi2,weight\n" + rows, {"phi1", "Phi", "phi2"}), "of o.csv");
    EXPECT_EQ(weights_of(rows, {"1", "2", "3", "4"}), "2 0 of o.csv by column 4");
    // The table of the cells of a run.
    EXPECT_EQ(weights_of("x,y,weight,phi1,Phi,phi2\n1,2,-3,10,20,30\n"), "of o.csv");
}

TEST(OrientationReader, WeightsThatAreNoneAreRefused) {
    EXPECT_EQ(weights_of("phi1,Phi,phi2,weight\n1,2,300,-1\n"),
              "o.csv:2: column 'weight': '-1' is not a weight; give a number from 0 to 1e150");
    EXPECT_THAT(weights_of("phi1,Phi,phi2,weight\n1,2,300,1e200\n"), HasSubstr("is not a weight"));
    EXPECT_THAT(weights_of("phi1,Phi,phi2,weight\n1,2,300,\n"), StartsWith("o.csv:2: "));
    EXPECT_EQ(weights_of("phi1,Phi,phi2,weight\n1,2,300,0\n4,5,6,0\n"),
              "o.csv: all weights are 0; give one orientation a positive weight");
    EXPECT_THAT(weights_of("1 2 3 4\n"), HasSubstr("or with one of weights four"));
    EXPECT_THAT(weights_of("1 2 3 4\n", {"1", "2", "3", "5"}),
                StartsWith("o.csv:1: there is no column '5'"));
}

TEST(OrientationReader, ListsOfDream3dAreKnown) {
    const std::string head =
        "# All lines starting with '#' are comments and should come before the data.\r\n"
        "# Angle Data is Comma delimited.\r\n# Euler angles are expressed in UNIT\r\n"
        "# Euler0 Euler1 Euler2 Weight Sigma\r\nAngle Count:2\r\n";
    const auto with = [&](const std::string& unit, const std::string& rows) {
        std::string text = head + rows;
        return text.replace(text.find("UNIT"), 4, unit);
    };
    const std::string rows = "1,2,3,7,1\r\n4,2.5,6,5,1\r\n";
    EXPECT_EQ(weights_of(with("degrees", rows)), "7 5 of o.csv by column 4");
    EXPECT_EQ(first_angles(with("degrees", rows)), "1 2 3");
    EXPECT_EQ(first_angles(with("radians", rows)), "57 115 172");
    EXPECT_THAT(first_angles(with("radians", rows), "deg"),
                HasSubstr("comments state another unit of the angles than deg:"));
    EXPECT_EQ(first_angles("Angle Count:1\n1 2 3 1 1\n", "rad"), "57 115 172");
    EXPECT_EQ(weights_of(with("degrees", "1,2,3,7,1\r\n")),
              "o.csv: its head states 2 orientations, but it has 1; correct the head, or restore "
              "the missing lines");
    EXPECT_THAT(weights_of(with("degrees", "1,2,3,7,1\r\n4,5,6,-5,1\r\n")),
                StartsWith("o.csv:7: "));
    EXPECT_THAT(weights_of("Angle Count:two\n1 2 3 1 1\n"), StartsWith("o.csv:1: "));
}

TEST(OrientationReader, ListsOfVpscAreKnown) {
    const std::string rows = "   1.00    2.00    3.00   0.2500000\n 300 5 6 0.75\n";
    for (const char* head : {"\n\n\nB 2\n", "texture exported by MTEX\n\n\nB 2\n",
                             "STRAIN = 0.1\n1 1 1\n0 0 0\nB   2  \n"}) {
        EXPECT_EQ(first_angles(head + rows), "1 2 3") << head;
        EXPECT_EQ(weights_of(head + rows), "0 1 of o.csv by column 4") << head;
    }
    EXPECT_THAT(weights_of("\n\n\nB 3\n" + rows), HasSubstr("states 3 orientations, but it has 2"));
    EXPECT_EQ(weights_of("\n\n\nK 2\n" + rows),
              "o.csv:4: the angles are those of Kocks; export Bunge's angles, which begin with B");
    EXPECT_THAT(weights_of("1 2\n1 2\n1 2\nA 2\n"), StartsWith("o.csv:1: "));
}

}  // namespace
}  // namespace pcvt
