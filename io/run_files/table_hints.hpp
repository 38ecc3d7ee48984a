#pragma once

#include <string>
#include <string_view>

#include "io/run_files/table_lines.hpp"

namespace pcvt {

/// Refuses files of other programs that are lists of atoms, but no tables: the dumps and the data
/// files of LAMMPS, and XYZ files.
/// @param first  at its first line with content.
/// @throws BadFile with what makes a table of such a file.
void refuse_atom_files(const TableLines& first);

/// Returns how to write a field that is nearly a number, such as "; write no separators of
/// thousands" for "1 234.5"; empty for any other text.
///
///     number_remedy("0.5D+02")  // "; write e before the exponent, as in 1.5e3"
std::string number_remedy(std::string_view field);

}  // namespace pcvt
