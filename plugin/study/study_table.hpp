#pragma once

#include <string>
#include <vector>

namespace pcvt {

using StudyRow = std::vector<std::string>;

/// Rows of text under named columns: what a study reads, writes and prints.
struct StudyTable {
    /// What precedes the extension of its file; empty for the main table.
    std::string suffix;
    /// Comment lines at the head of the file, without "# ".
    std::vector<std::string> notes;
    /// Findings, for the reader of the table; comment lines too.
    std::vector<std::string> remarks;
    std::vector<std::string> columns;
    std::vector<StudyRow> rows;

    /// @throws InternalError if there is none of this name.
    std::size_t column(const std::string& name) const;
    /// The number in a cell. @throws InvalidInput if it holds none.
    double number(const StudyRow& row, const std::string& name) const;
};

/// Comma-separated, RFC 4180 but for LF and the comment lines: no cell may hold a comma, a quote or
/// a line end (InternalError).
std::string encode_csv(const StudyTable& table);

/// Reads what encode_csv wrote; all comment lines become notes.
/// @throws BadFile `name:line: what; what to do`.
StudyTable decode_csv(const std::string& name, const std::string& text);

/// SpatialSort aligned for the eye, the first `most_columns` of them; then the remarks.
std::string aligned_text(const StudyTable& table, std::size_t most_columns);

/// Cells: shortest decimals that read back as the number, and so many significant digits at most.
std::string in_full(double value);
std::string rounded(double value, int digits);

}  // namespace pcvt
