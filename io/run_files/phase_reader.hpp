#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "io/bytes/bad_file.hpp"
#include "io/run_files/table_name.hpp"

namespace pcvt {

/// The phase of each site in a table; site s has the s-th row.
///
/// Example usage:
///     const PhaseFile file = read_phases(parse_table_name("ebsd.csv:Phase"));
///     const std::string& first = file.names[file.site_phases[0]];
struct PhaseFile {
    /// The phases in the order in which the table names them first.
    std::vector<std::string> names = {};
    /// The index of each site's phase in `names`.
    std::vector<int> site_phases = {};
};

/// Reads one name of a phase a row: a table as TableScanner takes it. The column is the one that is
/// named; else in a header the column `phase`; else the only one.
/// @throws BadFile with the line for any other text, and for a name that is not one of 1 to 60
///         letters, digits, _ and -, or that differs from another one only by its case.
PhaseFile parse_phase_table(const TableName& name, std::string_view text);

/// Reads the phases of a regular file.
PhaseFile read_phases(const TableName& name);

}  // namespace pcvt
