#pragma once

#include "mesher/finite_volume/mpas_rows.hpp"

namespace pcvt {

/// Proves law (1) of MpasGrid: the tables of cells, edges and vertices agree.
///
/// Example usage:
///     prove_mpas_tables(grid, MpasRows(grid));
///
/// @pre The tables have the sizes that MpasGrid states.
/// @throws NotATile naming the cell, edge or vertex.
void prove_mpas_tables(const MpasGrid& grid, const MpasRows& rows);

}  // namespace pcvt
