#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/run_files/site_reader.hpp"
#include "io/run_files/site_writer.hpp"
#include "tests/support/damaged_text.hpp"
#include "tests/support/polyhedra.hpp"

namespace pcvt {
namespace {

TEST(SpaceSiteReader, GivesBackTheSameSites) {
    const space::Points points = uniform_points(space::Lattice::box(1, 2, 3), 50, 1);
    EXPECT_EQ(parse_sites<3>({.path = "s.txt"}, encode_sites(points)).points, points);
}

TEST(SpaceSiteReader, ReadsCommentsAndBlankLines) {
    const SpaceSiteFile file =
        parse_sites<3>({.path = "s.txt"}, "# head\r\n\r\n1 2\t3 # one\n4 5 6");
    EXPECT_EQ(file.lines, (std::vector<int>{3, 4}));
    EXPECT_EQ(file.points.col(1), space::Vec3(4, 5, 6));
}

TEST(SpaceSiteReader, NamesTheLineOfAFault) {
    const auto fault = [](const std::string& text) {
        return testing::fault_in([&] { parse_sites<3>({.path = "s.txt"}, text); });
    };
    EXPECT_THAT(fault("1 2 3\n1 2\n"), ::testing::StartsWith("s.txt:2: "));
    EXPECT_THAT(fault("1 2 x\n"), ::testing::StartsWith("s.txt:1: "));
    EXPECT_THAT(fault("# none\n"), ::testing::HasSubstr("holds no site"));
}

TEST(SpaceSiteReader, NamesTheLinesOfEqualSites) {
    const SpaceSiteFile file = parse_sites<3>({.path = "s.txt"}, "0 0 0\n# a comment\n1 0 0\n");
    const BadFile fault = duplicate_lines(file, DuplicateSites(0, 1));
    EXPECT_THAT(fault.what(),
                ::testing::StartsWith("s.txt:3: the site coincides with the site of line 1"));
}

TEST(SpaceSiteReader, NamesAllLinesOfCoincidentSites) {
    const SpaceSiteFile file =
        parse_sites<3>({.path = "s.txt"}, "0 0 0\n# a comment\n1 0 0\n0 0 0\n");
    const BadFile fault = duplicate_lines(file, DuplicateSites({{1, 0}, {2, 0}}));
    EXPECT_STREQ(fault.what(),
                 "s.txt:3: 2 sites coincide with earlier ones modulo the lattice, to 1e-9 of the "
                 "spacing: line 3 with line 1, line 4 with line 1; remove them, or give the "
                 "periods by --period or --lattice, or add --duplicates drop");
}

}  // namespace
}  // namespace pcvt
