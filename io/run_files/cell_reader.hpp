#pragma once

#include <string>
#include <string_view>

#include "io/run_files/cell_rows.hpp"

namespace pcvt {

/// Whether a table of cells reads back as these rows: every number bit by bit, every name, and
/// empty fields where there is nothing to say.
///
/// Example usage:
///     if (!reads_back("cells.csv", encode_cells(rows), rows)) report_a_fault();
///
/// @param name  the file's name in messages.
/// @throws BadFile  naming the line if the text is not a table of cells.
bool reads_back(const std::string& name, std::string_view text, const CellRows& rows);

}  // namespace pcvt
