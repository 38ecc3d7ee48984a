#pragma once

#include "mesher/cells/cell_table.hpp"
#include "mesher/space/mesh/cell_complex.hpp"

namespace pcvt::space {

/// Measures the cells of a torus. The neighbours of a cell are in rising order.
///
/// Laws, tested by number:
///   (1) The volumes sum to that of the domain.
///   (2) s has t as a neighbour as often as t has s, once for each of their faces.
///
/// Example usage:
///   const CellTable cells = cell_table(cell_complex(sites, tetrahedra));
///   for (SiteId s = 0; s < cells.n_cells(); ++s) total += cells.measure[s];
CellTable cell_table(const CellComplex& complex);

}  // namespace pcvt::space
