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
                .front();
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

}  // namespace
}  // namespace pcvt
