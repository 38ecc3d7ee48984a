#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/run_files/table_lines.hpp"

namespace pcvt {

/// A column as a header states it: "ECD (µm)" has the name ECD and the unit um.
struct TableColumn {
    std::string name;
    /// The text in brackets behind the name, in ASCII; empty without brackets.
    std::string unit = {};
};

/// Whether the first line of a table is a header: none of its fields is a number, and one of them
/// holds a letter.
bool is_header(std::span<const std::string_view> fields);

/// Returns the columns of a header. Between blanks, brackets belong to the word before them.
std::vector<TableColumn> header_columns(std::span<const std::string_view> fields,
                                        Separator separator);

/// Splits a field of a header into name and unit.
TableColumn header_column(std::string_view field);

/// Returns a name as names of columns are compared: in small letters, without blanks, underscores,
/// hyphens and points; the Greek letter phi is "phi".
///
///     comparable_name("Equivalent_Diameter")  // "equivalentdiameter"
std::string comparable_name(std::string_view name);

}  // namespace pcvt
