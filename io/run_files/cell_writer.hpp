#pragma once

#include <string>

#include "io/run_files/cell_rows.hpp"

namespace pcvt {

/// Encodes the cells as a .csv file: comments that begin with #, a header, one row a site. Fields
/// that do not apply to the cells are empty. The neighbours of a cell are separated by blanks.
///
/// Example usage:
///     output.stage("cells.csv", encode_cells({sites, cell_table(cells)}));
///
/// @throws InternalError if a number is not finite.
std::string encode_cells(const CellRows& rows);

}  // namespace pcvt
