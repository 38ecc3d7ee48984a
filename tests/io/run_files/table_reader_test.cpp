#include "io/run_files/table_reader.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <numbers>

#include "io/run_files/area_reader.hpp"
#include "io/run_files/orientation_reader.hpp"
#include "io/run_files/site_reader.hpp"

namespace pcvt {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;

/// One form of a table.
struct TableForm {
    std::string separator;
    bool has_header;
    bool has_decimal_commas;
    std::string line_end;
    bool has_byte_order_mark;
    /// Behind the names of the header, "" or " (um)".
    std::string unit;
    bool is_quoted;

    std::string words() const {
        return separator + (has_header ? " header" : "") + (has_decimal_commas ? " commas" : "") +
               (line_end == "\r\n" ? " CRLF"
                : line_end == "\r" ? " CR"
                                   : " LF") +
               (has_byte_order_mark ? " mark" : "") + unit + (is_quoted ? " quotes" : "");
    }
};

std::vector<TableForm> table_forms(const std::string& unit) {
    std::vector<TableForm> forms;
    for (const char* separator : {",", ";", "\t", " ", ", ", " \t "}) {
        for (int bits = 0; bits < 32; ++bits) {
            for (const char* line_end : {"\n", "\r\n", "\r"}) {
                const TableForm form{separator,       (bits & 1) != 0, (bits & 2) != 0,
                                     line_end,        (bits & 4) != 0, (bits & 8) != 0 ? unit : "",
                                     (bits & 16) != 0};
                const bool is_strict = form.separator == ";" || form.separator == "\t";
                if (form.has_decimal_commas && !is_strict) continue;
                if (!form.has_header && !form.unit.empty()) continue;
                forms.push_back(form);
            }
        }
    }
    return forms;
}

/// Writes fields in a form; the first row holds the names of the columns.
std::string in_form(const TableForm& form, const std::vector<std::vector<std::string>>& rows) {
    std::string text = form.has_byte_order_mark ? "\xEF\xBB\xBF" : "";
    text += "# a comment" + form.line_end + form.line_end;
    for (std::size_t r = form.has_header ? 0 : 1; r < rows.size(); ++r) {
        for (std::size_t k = 0; k < rows[r].size(); ++k) {
            std::string field = rows[r][k] + (r == 0 ? form.unit : "");
            if (r > 0 && form.has_decimal_commas)
                std::replace(field.begin(), field.end(), '.', ',');
            if (form.is_quoted) field = '"' + field + '"';
            text += (k == 0 ? "" : form.separator) + field;
        }
        text += r + 1 == rows.size() ? "" : form.line_end;
    }
    return text;
}

TEST(TableMatrix, SitesAreReadInEveryForm) {
    for (const TableForm& form : table_forms(" (um)")) {
        const std::string text = in_form(form, {{"X", "y"}, {"0.5", "-1.25"}, {"3", "0.125"}});
        SCOPED_TRACE(form.words());
        const SiteFile file = parse_sites<2>({.path = "s.txt"}, text);
        ASSERT_EQ(file.points.cols(), 2);
        EXPECT_EQ(file.points.col(0), plane::Vec2(0.5, -1.25));
        EXPECT_EQ(file.points.col(1), plane::Vec2(3, 0.125));
        EXPECT_EQ(file.lines[1] - file.lines[0], 1);
        EXPECT_EQ(file.lines[0], form.has_header ? 4 : 3);
    }
}

TEST(TableMatrix, SizesAreReadInEveryForm) {
    for (const TableForm& form : table_forms(" [mm]")) {
        const std::string text =
            in_form(form, {{"Feature_ID", "ECD", "phase"}, {"1", "2.5", "3"}, {"2", "0.5", "1"}});
        SCOPED_TRACE(form.words());
        const TableName name{.path = "e.csv",
                             .columns = {form.has_header ? "ecd" : "2"},
                             .prefix = form.has_header ? "" : "diameter"};
        const AreaFile file = parse_areas(name, text);
        const std::string unit = form.unit.empty() ? "" : " (mm)";
        EXPECT_EQ(file.description, form.has_header ? "diameters of column ECD" + unit + " of e.csv"
                                                    : "diameters of column 2 of e.csv");
        ASSERT_EQ(file.areas.size(), 2);
        EXPECT_NEAR(file.areas[0], 6.25 * std::numbers::pi / 4, 1e-14);
        EXPECT_NEAR(file.areas[1], 0.25 * std::numbers::pi / 4, 1e-15);
        if (!form.has_header) continue;
        EXPECT_EQ(parse_areas({.path = "e.csv"}, text).areas, file.areas);
    }
}

TEST(TableMatrix, AnglesAreReadInEveryForm) {
    for (const TableForm& form : table_forms(" (rad)")) {
        const std::string text =
            in_form(form, {{"phi1", "PHI", "Phi2"}, {"0.5", "0.25", "-1.5"}, {"0.1", "1", "0.75"}});
        SCOPED_TRACE(form.words());
        const double factor = form.unit.empty() ? 1 : 180 / std::numbers::pi;
        const std::vector<BungeAngles> angles = parse_orientations({.path = "o.txt"}, text).angles;
        ASSERT_EQ(angles.size(), 2U);
        EXPECT_EQ(angles[0].phi1, 0.5 * factor);
        EXPECT_EQ(angles[0].Phi, 0.25 * factor);
        EXPECT_EQ(angles[0].phi2, -1.5 * factor);
    }
}

/// The numbers of one column.
std::vector<double> column_of(std::string_view text, const std::string& column) {
    TableScanner scanner("t.csv", text);
    const std::size_t k = scanner.choose({column}).front();
    std::vector<double> numbers;
    while (scanner.next()) numbers.push_back(scanner.number(k));
    return numbers;
}

std::string table_fault(std::string_view text, const std::string& column = "2") {
    try {
        column_of(text, column);
    } catch (const BadFile& fault) {
        return fault.what();
    }
    return "";
}

TEST(TableScanner, LinesAboveTheHeaderOfOtherProgramsAreSkipped) {
    EXPECT_THAT(column_of("sep=;\nid;d\n1;2,5\n", "d"), ElementsAre(2.5));
    EXPECT_THAT(column_of("2\nid,d\n1,2\n2,4\n", "d"), ElementsAre(2, 4));
    EXPECT_THAT(column_of(" ,Area,Mean\n1,20,3\n2,40,5\n", "area"), ElementsAre(20, 40));
}

TEST(TableScanner, NamesAreComparedWithoutCaseBlanksAndUnits) {
    const char* const text = "Feature ID\tEquivalent_Diameter (\xC2\xB5m)\tphase\n1\t2.5\t\n";
    for (const char* name : {"equivalentdiameter", "Equivalent Diameter", "EQUIVALENT-DIAMETER",
                             "equivalent_diameter (um)", "2"}) {
        EXPECT_THAT(column_of(text, name), ElementsAre(2.5)) << name;
    }
    EXPECT_THAT(column_of("Area (px),Area (um)\n1,2\n", "area (um)"), ElementsAre(2));
    EXPECT_THAT(table_fault("Area (px),Area (um)\n1,2\n", "area"),
                StartsWith("t.csv:1: columns 1 and 2 are both called 'area'; "));
}

TEST(TableScanner, ASingleNameMayHoldBlanks) {
    EXPECT_THAT(column_of("Grain size (um)\n1\n2\n", "grain size"), ElementsAre(1, 2));
    EXPECT_THAT(column_of("x (um) y (um)\n1 2\n", "y"), ElementsAre(2));
}

TEST(TableScanner, OneEmptyFieldBehindTheLastOneDoesNotCount) {
    EXPECT_THAT(column_of("id;d\n1;2;\n2;3\n", "d"), ElementsAre(2, 3));
    EXPECT_THAT(column_of("1;2;\n2;3;\n", "2"), ElementsAre(2, 3));
    EXPECT_THAT(column_of("id\td\t\n1\t2\t\n2\t3\n", "d"), ElementsAre(2, 3));
}

TEST(TableScanner, EmptyFieldsAtTheEndsOfALineCount) {
    EXPECT_THAT(column_of("id\td\tphase\n\t2\t\n2\t3\t1\n", "d"), ElementsAre(2, 3));
    EXPECT_THAT(column_of("id,d,phase\n,2,\n2,3,1\n", "d"), ElementsAre(2, 3));
}

TEST(TableScanner, OneColumnBelowAHeaderMayHaveDecimalCommas) {
    EXPECT_THAT(table_fault("d\n1,234\n", "d"), StartsWith("t.csv:2: the comma may be a decimal "));
    EXPECT_THAT(table_fault("d\n0,5\n0.5\n", "d"),
                StartsWith("t.csv:3: '0.5' has a decimal point, a number of line 2 has a comma"));
}

TEST(TableScanner, WrongRowsAreRefusedByLineAndColumn) {
    const std::vector<std::pair<std::string, std::string>> faults = {
        {"id,d\n1,2\n2\n",
         "t.csv:3: the row has 1 field with commas between them, but the header "},
        {"id,d\n1,2\n2,0,5\n", "t.csv:3: the row has 3 fields with commas between them, but the "},
        {"1;2\n1;2;3\n", "t.csv:2: the row has 3 fields with semicolons between them, but the "},
        {"id,d\n1,\n", "t.csv:2: column 'd': the field is empty; give a number"},
        {"id,d\n1,x\n", "t.csv:2: column 'd': 'x' is not a number; write a decimal"},
        {"id,d\n1,nan\n", "t.csv:2: column 'd': 'nan' is not a finite number; "},
        {"id,d\n1,1 234\n", "t.csv:2: column 'd': '1 234' is not a number; "},
        {"id,d\n1,\"1,5\"\n", "t.csv:2: column 'd': '1,5' is not a number; write a decimal point"},
        {"id;d\n1;1.234,5\n", "t.csv:2: column 'd': '1.234,5' has 2 decimal marks; write one"},
        {"id;d\n1;1,234,567\n", "t.csv:2: column 'd': '1,234,567' has 2 decimal marks; "},
        {"id;d\n1;0,5\n2;0.5\n",
         "t.csv:3: column 'd': '0.5' has a decimal point, a number of line "
         "2 has a comma; "},
        {"id\td\n1\t0.5\n2\t0,5\n", "t.csv:3: column 'd': '0,5' has a decimal comma, a number "},
        {"id;d\n1;x,5\n", "t.csv:2: column 'd': 'x,5' is not a number; write a decimal"},
        {"id;d\n1;1,234\n2;12,500\n", "t.csv:2: the comma may be a decimal mark or stand between "},
        {"ITEM: TIMESTEP\n0\n", "t.csv:1: a LAMMPS dump; keep the names of columns behind "},
        {"1,5 2,5\n", "t.csv:1: column 2: '2,5' is not a number; use a decimal point"},
        {"id,\"d\n1,2\n", "t.csv:1: a quote is not closed; "},
        {"id,d\n1,2\n\n1 2\n", "t.csv:4: the row has 1 field with commas"},
        {"id\td\n1\t2\n1 2\n", "t.csv:3: the row has 1 field with tabs"},
        {"id,d\n1,1e999\n", "t.csv:2: column 'd': '1e999' is beyond the range"},
        {"1 2\n# c\n1 2 3\n", "t.csv:3: the row has 3 fields with blanks between them, but the "},
        {"id,d,d\n1,2,3\n", "t.csv:1: columns 2 and 3 are both called 'd'; "},
    };
    for (const auto& [text, fault] : faults) {
        const bool has_header = text.starts_with("id");
        EXPECT_THAT(table_fault(text, has_header ? "d" : "2"), StartsWith(fault)) << text;
    }
}

TEST(TableScanner, ACommaThatMayStandBetweenThousandsIsSettledByAnotherOne) {
    EXPECT_THAT(column_of("id;d\n1;1,234\n2;0,500\n", "d"), ElementsAre(1.234, 0.5));
    EXPECT_THAT(column_of("Diameter\n0,8618\n1,3472\n2\n", "diameter"),
                ElementsAre(0.8618, 1.3472, 2));
    EXPECT_THAT(column_of("id;d\n1;1,234\n2;12,5\n", "d"), ElementsAre(1.234, 12.5));
}

TEST(TableScanner, UnknownColumnsAreRefusedWithTheKnownOnes) {
    EXPECT_EQ(table_fault("\nid,d\n1,2\n", "e"),
              "t.csv:2: there is no column 'e'; take one of 'id', 'd'");
    EXPECT_EQ(table_fault("1,2\n", "3"),
              "t.csv:1: there is no column '3'; take a number from 1 to 2");
    EXPECT_EQ(table_fault("1,2\n", "d"),
              "t.csv:1: there is no column 'd'; take a number from 1 to 2");
}

TEST(TableScanner, FieldsOfColumnsThatAreNotReadMayBeAnything) {
    EXPECT_THAT(column_of("site,x,phase,neighbours\n0,0.5,,1 2 3\n1,1.5,\"a,b\",x\n", "x"),
                ElementsAre(0.5, 1.5));
}

TEST(TableScanner, WordsAreReadAsTheyAre) {
    TableScanner scanner("t.csv", "site,phase\n0,Ferrite\n1,\n");
    const std::size_t phase = *scanner.find("Phase");
    ASSERT_TRUE(scanner.next());
    EXPECT_EQ(scanner.word(phase), "Ferrite");
    ASSERT_TRUE(scanner.next());
    EXPECT_THROW(scanner.word(phase), BadFile);
    EXPECT_FALSE(scanner.next());
}

}  // namespace
}  // namespace pcvt
