#pragma once

#include <string>

#include "mesher/lattice/lattice.hpp"
#include "mesher/mesh/cell_table.hpp"

namespace pcvt {

/// Encodes the cells as a .csv file: comments that begin with #, a header, one row a site. Fields
/// that do not apply to the cells are empty. The neighbours of a cell are separated by blanks.
///
/// Example usage:
///     output.stage("cells.csv", encode_cells(sites, cell_table(cells)));
///
/// @param sites  2 x n, one column a cell.
/// @throws InternalError if a number is not finite.
std::string encode_cells(const Points& sites, const CellTable& cells);

}  // namespace pcvt
