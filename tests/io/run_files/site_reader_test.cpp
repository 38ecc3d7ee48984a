#include "io/run_files/site_reader.hpp"

#include <gmock/gmock.h>
#include <rapidcheck.h>

#include "io/run_files/site_writer.hpp"
#include "mesher/plane/geometry/sites.hpp"
#include "tests/support/mutation.hpp"
#include "tests/support/temporary_folder.hpp"

namespace pcvt {
namespace {

using ::testing::ElementsAre;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::StartsWith;

std::string site_fault(std::string_view text) {
    try {
        parse_sites<2>({.path = "s.txt"}, text);
    } catch (const BadFile& fault) {
        return fault.what();
    }
    return "";
}

TEST(SiteReader, SitesAndTheirLinesAreRead) {
    const SiteFile file =
        parse_sites<2>({.path = "s.txt"}, "# head\n0.25 0.5\n\n -1.5e1\t+2 # tail\n3 4#x\n");
    ASSERT_EQ(file.points.cols(), 3);
    EXPECT_EQ(file.points.col(0), plane::Vec2(0.25, 0.5));
    EXPECT_EQ(file.points.col(1), plane::Vec2(-15, 2));
    EXPECT_EQ(file.points.col(2), plane::Vec2(3, 4));
    EXPECT_THAT(file.lines, ElementsAre(2, 4, 5));
    EXPECT_EQ(file.name, "s.txt");
}

TEST(SiteReader, TheHeaderStatesTheUnit) {
    const auto unit = [](std::string_view text, std::vector<std::string> columns = {}) {
        return parse_sites<2>({.path = "s.txt", .columns = std::move(columns)}, text).unit;
    };
    EXPECT_EQ(unit("x [\xC2\xB5m];y(\xC2\xB5m)\n1;2\n"), "um");
    EXPECT_EQ(unit("id,Xc (mm),Yc (mm)\n1,2,3\n", {"xc", "yc"}), "mm");
    for (const char* text : {"x,y\n1,2\n", "1 2\n"}) EXPECT_EQ(unit(text), "");
    EXPECT_EQ(unit("1,2,3\n", {"2", "3"}), "");
    EXPECT_THROW(unit("id,Xc (mm),Yc (um)\n1,2,3\n", {"xc", "yc"}), BadFile);
}

TEST(SiteReader, LineEndsMarksAndSignsOfZeroAreAccepted) {
    const SiteFile file =
        parse_sites<2>({.path = "s.txt"}, "\xEF\xBB\xBF-0.0 1\r\n# c\r\n\t7\t-0\r\n0.1 0.2");
    ASSERT_EQ(file.points.cols(), 3);
    EXPECT_EQ(file.points.col(0), plane::Vec2(0, 1));
    EXPECT_EQ(file.points.col(1), plane::Vec2(7, 0));
    EXPECT_THAT(file.lines, ElementsAre(1, 3, 4));
}

TEST(SiteReader, EachFaultNamesItsLineAndARemedy) {
    EXPECT_THAT(site_fault("0 0\n0.5 nan\n"),
                StartsWith("s.txt:2: 'nan' is not a finite number; "));
    EXPECT_THAT(site_fault("0 0\n\n-inf 1"),
                StartsWith("s.txt:3: '-inf' is not a finite number; "));
    EXPECT_THAT(site_fault("1,5 2,5"), StartsWith("s.txt:1: '1,5' is not a number; use a decimal"));
    EXPECT_THAT(site_fault("x 1\n0 0"), StartsWith("s.txt:1: 'x' is not a number; "));
    EXPECT_THAT(site_fault("a b\n0 0"),
                StartsWith("s.txt:1: the header has no column x; name the columns of"));
    EXPECT_THAT(site_fault("0.5"),
                StartsWith("s.txt:1: a site has 2 coordinates, this line has 1; "));
    EXPECT_THAT(site_fault("1 2 3"),
                StartsWith("s.txt:1: a site has 2 coordinates, this line has 3"));
    EXPECT_THAT(site_fault("1e400 0"), StartsWith("s.txt:1: '1e400' is beyond the range"));
}

TEST(SiteReader, FaultsOfTheWholeFileNameTheFile) {
    EXPECT_EQ(site_fault(""), "s.txt: holds no site; give one \"x y\" a line");
    EXPECT_EQ(site_fault("# nothing\n\n"), "s.txt: holds no site; give one \"x y\" a line");
}

TEST(SiteReader, BinaryFilesAreRefusedWithALine) {
    const std::string remedy =
        ": holds a NUL byte, so it appears to be a binary file; give a text with \"x y\" a line";
    EXPECT_EQ(site_fault(std::string_view("0 0\n\0\1", 6)), "s.txt:2" + remedy);
    EXPECT_EQ(site_fault(std::string_view("0 0\r\n1 1\r2 2\r\n\r\0", 16)), "s.txt:5" + remedy);
    EXPECT_EQ(site_fault(std::string_view("0\0 \0", 4)), "s.txt:1" + remedy);
    for (const char* mark : {"\xFF\xFE", "\xFE\xFF"}) {
        EXPECT_EQ(site_fault(mark + std::string("0\0 \0", 4)),
                  "s.txt:1: the text is UTF-16; save it as UTF-8");
    }
    for (const char* binary : {"\x1F\x8B\x08", "\x89PNG\r\n\x1A\n",
                               "\x7F"
                               "ELF",
                               "PK\3\4", "\x80"}) {
        EXPECT_THAT(site_fault(binary), StartsWith("s.txt:1: ")) << binary;
    }
}

TEST(SiteReader, DuplicatesAreReportedWithTheirLines) {
    const SiteFile file = parse_sites<2>({.path = "s.txt"}, "# head\n0 0\n0.5 0.5\n\n1 0\n");
    EXPECT_STREQ(
        duplicate_lines(file, DuplicateSites(0, 2)).what(),
        "s.txt:5: the site coincides with the site of line 2 modulo the lattice, "
        "to 1e-9 of the spacing; remove one, or give the periods by --period or --lattice, or add "
        "--duplicates drop");
    const SiteFile same = parse_sites<2>({.path = "s.txt"}, "0.5 1\n0.5 1\n");
    EXPECT_THAT(duplicate_lines(same, DuplicateSites(0, 1)).what(),
                EndsWith("; remove one, or add --duplicates drop"));
}

TEST(SiteReader, WrittenSitesReadBackExactlyAndInOrder) {
    const testing::TemporaryFolder folder;
    plane::Points points(2, 5);
    points << 0.1, -0.0, 1e-310, 1e300, 1.0 / 3, 0.7, 5, -2e-9, -1, 2.0 / 3;
    testing::write_bytes(folder / "s.txt", encode_sites(points));
    EXPECT_EQ(read_sites<2>({.path = folder / "s.txt"}).points, points);
}

TEST(SiteReader, ATextReadsBackAsItsOwnSitesOnly) {
    plane::Points points(2, 3);
    points << 0.1, -0.0, 1.0 / 3, 0.7, 5, 2.0 / 3;
    const std::string text = encode_sites(points);
    EXPECT_TRUE(reads_back("s.txt", text, points));
    EXPECT_FALSE(reads_back("s.txt", text + "0 0\n", points));
    EXPECT_FALSE(reads_back("s.txt", text, plane::Points(points.leftCols(2))));
    points(1, 2) = std::nextafter(points(1, 2), 1);
    EXPECT_FALSE(reads_back("s.txt", text, points));
    EXPECT_THROW(reads_back("s.txt", "0.1 0.7 2\n", points), BadFile);
}

TEST(SiteReader, DamagedTextGivesSitesOrAFaultAndNothingElse) {
    std::mt19937_64 random(1);
    const std::string text = encode_sites(uniform_points(plane::Lattice({1, 0}, {0, 1}), 20, 0));
    for (int k = 0; k < 5000; ++k) {
        try {
            EXPECT_TRUE(parse_sites<2>({.path = "s.txt"}, testing::mutated(text, random))
                            .points.allFinite());
        } catch (const BadFile& fault) {
            EXPECT_THAT(fault.what(), StartsWith("s.txt"));
        }
    }
}

}  // namespace
}  // namespace pcvt
