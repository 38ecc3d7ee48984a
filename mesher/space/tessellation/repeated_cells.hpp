#pragma once

#include "mesher/cells/cell_materials.hpp"
#include "mesher/space/tessellation/tessellation.hpp"
#include "mesher/torus/repetition.hpp"

namespace pcvt::space {

/// The cells of several periods as those of one period of the repeated lattice. Site s of the copy
/// (i, j, k) is site s + n (i + columns (j + rows k)), n the number of sites of one period, with
/// the weight of site s. The triangulation is computed again, so that cells of different copies are
/// equal up to rounding.
///
/// Example usage:
///     const PeriodicDelaunay eight = repeated_cells(cells.delaunay, {2, 2, 2});
PeriodicDelaunay repeated_cells(const PeriodicDelaunay& delaunay, const Repetition& repeat);

/// The same with the elongation of the cells and the figures of their run.
Tessellation repeated_cells(const Tessellation& cells, const Repetition& repeat);

/// The materials of the cells of several periods.
CellMaterials repeated_materials(const CellMaterials& materials, const Repetition& repeat);

/// The lattice of several periods.
Lattice repeated_lattice(const Lattice& lattice, const Repetition& repeat);

}  // namespace pcvt::space
