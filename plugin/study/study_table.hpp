#pragma once

#include <string>
#include <vector>

namespace pcvt {

using StudyRow = std::vector<std::string>;

/// Rows of text under named columns, as a study reads, writes and prints them.
///
///   const StudyTable runs = decode_csv("fig11-runs.csv", text);
///   for (const StudyRow& row : runs.rows) sum += runs.number(row, "energy");
struct StudyTable {
    /// Precedes the extension of its file; empty for the main table.
    std::string suffix;
    /// Comment lines at the head of the file, without "# ".
    std::vector<std::string> notes;
    /// Conclusions for the reader of the table; also comment lines.
    std::vector<std::string> remarks;
    std::vector<std::string> columns;
    std::vector<StudyRow> rows;

    /// @throws InternalError if no column has this name.
    std::size_t column(const std::string& name) const;
    /// The number in a cell. @throws InvalidInput if the cell holds no number, or one that no run
    /// has: above 1e100 or below 1e-100 in size.
    double number(const StudyRow& row, const std::string& name) const;
};

/// Comma-separated values as in RFC 4180, except for LF and the comment lines.
/// @throws InternalError if a cell holds a comma, a quote or a line end.
std::string encode_csv(const StudyTable& table);

/// Reads a table of encode_csv; all comment lines become notes.
/// @throws BadFile "name:line: fault; remedy".
StudyTable decode_csv(const std::string& name, const std::string& text);

/// The first `most_columns` columns, aligned for readers, and then the remarks.
std::string aligned_text(const StudyTable& table, std::size_t most_columns);

/// A number as a cell: the shortest decimals that read back as it, or at most `digits` significant
/// digits.
std::string in_full(double value);
std::string rounded(double value, int digits);

}  // namespace pcvt
