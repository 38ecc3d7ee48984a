#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/bytes/bad_file.hpp"
#include "io/run_files/table_header.hpp"
#include "io/run_files/table_lines.hpp"
#include "io/run_files/table_name.hpp"

namespace pcvt {

/// Walks over the rows of a table of text, one row at a time. Accepts LF, CRLF and CR, a UTF-8 byte
/// order mark, blank lines, comments after a #, quotes round fields, and above the header a line
/// "sep=;" or the number of the rows. The first line decides how the table is read:
///   (1) It is a header if none of its fields is a number and one of them holds a letter.
///   (2) It has the separator of all rows, see separator_of(); without a header, tabs are blanks
///       unless numbers have decimal commas.
///   (3) Between semicolons and tabs, and below a header with a single name, all numbers may have a
///       decimal comma; elsewhere, none may.
/// Below a header, and once columns are chosen, all rows have as many fields; one empty field
/// behind the last one does not count.
///
/// Example usage:
///     TableScanner scanner("ebsd.csv", text);
///     const std::size_t column = scanner.choose({"ECD"}).front();
///     while (scanner.next()) diameters.push_back(scanner.number(column));
///
/// All faults are BadFile `name:line: fault; remedy`.
class TableScanner {
   public:
    /// Reads the header, if there is one.
    /// @param name        the file's name in messages.
    /// @param text        must outlive the scanner.
    /// @param has_header  false: the first line is a row, also if it consists of words.
    TableScanner(std::string name, std::string_view text, bool has_header = true);

    const std::string& name() const { return lines_.name(); }
    bool has_header() const { return !header_.empty(); }
    const std::vector<TableColumn>& header() const { return header_; }
    Separator separator() const { return separator_; }
    /// The number of fields of the header or of the first row; 0 if the table is empty.
    std::size_t n_columns() const { return n_columns_; }

    /// Returns the only column of the header with this name, as comparable_name() compares names.
    /// @throws BadFile if two columns have the name.
    std::optional<std::size_t> find(std::string_view column) const;
    /// Returns the columns that a user has named: each by its name in the header, with its unit
    /// where two columns have the name, else by its number from 1.
    /// @throws BadFile for any other text.
    std::vector<std::size_t> choose(const std::vector<std::string>& columns);

    /// Advances to the next row whose fields are not all empty, as spreadsheets write them below a
    /// table; returns false at the end of the table.
    /// @throws BadFile for a row with too few or too many fields.
    bool next();
    /// The line of the current row, counted from 1.
    int line() const { return lines_.line(); }
    /// The current row as it is.
    std::string_view content() const { return lines_.content(); }
    /// The fields of the current row.
    const std::vector<std::string_view>& fields() const { return fields_; }
    /// Returns the number in a field of the current row.
    /// @throws BadFile if the field is empty or not a number.
    double number(std::size_t column);
    /// Returns a field of the current row that is not empty, such as the name of a phase.
    std::string_view word(std::size_t column) const;

    /// Refuses the current row.
    [[noreturn]] void refuse(const std::string& complaint) const;
    /// Refuses a field of the current row; the message names its column if the table has several
    /// and a header, or if columns are chosen.
    [[noreturn]] void refuse(std::size_t column, const std::string& complaint) const;
    /// Refuses the header, or the first row if there is none.
    [[noreturn]] void refuse_header(const std::string& complaint) const;

    /// How messages name a column: "column 'ECD'" or "column 2".
    std::string label(std::size_t column) const;
    /// How a user may name a column in the name of the table: by its name in the header, else by
    /// its number from 1 where there is none, where two columns have it, or where a terminal could
    /// not show it.
    std::string typed(std::size_t column) const;
    /// The columns of the header for messages: "'id', 'ECD', 'phase'", with title_remedy() behind
    /// them.
    std::string listed_columns() const;
    /// For messages about the header: how to remove a title, if the row below is a header; else
    /// empty.
    std::string title_remedy() const;

   private:
    void read_header(bool may_be_header);
    void join_header(const TableLines& header);
    [[noreturn]] void refuse_width() const;
    void refuse_near_number(std::size_t column, std::string_view field) const;
    double decimal_number(std::size_t column, std::string_view field);

    TableLines lines_;
    std::vector<std::string_view> fields_;
    std::vector<TableColumn> header_;
    std::size_t n_columns_ = 0;
    int header_line_ = 0;
    int row_below_header_ = 0;
    /// Whether the row below the header consists of words, as a header below a title does.
    bool may_be_title_ = false;
    Separator separator_ = Separator::kBlanks;
    bool names_columns_ = false;
    bool requires_width_ = false;
    /// The first decimal mark between semicolons or tabs, and its line.
    char mark_ = 0;
    int mark_line_ = 0;
    /// The line of the first number whose comma may stand between thousands, as in 1,234. A number
    /// such as 0,5, whose comma can only be a decimal one, settles it.
    int unclear_line_ = 0;
    bool has_clear_comma_ = false;
};

/// The place of a column in words for a summary: " of column ECD (um) of ebsd.csv", or " of e.txt"
/// where a table has no header and the user has named no column.
std::string place_in_words(const TableScanner& scanner, const TableName& name, std::size_t column);

/// Requires one row for each site.
/// @param lines     of the rows, counted from 1.
/// @param quantity  of each row, for messages: "area".
/// @throws BadFile naming the last row, or the first one too many.
void require_one_row_a_site(const std::string& name, const std::vector<int>& lines, int n_sites,
                            const std::string& quantity);

}  // namespace pcvt
