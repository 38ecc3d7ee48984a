#pragma once

#include "mesher/cells/cell_table.hpp"
#include "mesher/plane/mesh/periodic_mesh.hpp"

namespace pcvt::plane {

/// Measures the cells of a torus.
///
/// Laws, tested by number:
///   (1) The areas sum to that of the domain.
///   (2) If no edge is shorter than kShortEdge h and three cells meet at every vertex, the sides
///       sum to 6 n.
///   (3) Without shorter edges, s has t as a neighbour once for each Delaunay edge from s to t.
///
/// Example usage:
///   const CellTable cells = cell_table(cell_mesh(delaunay));
///   for (SiteId s = 0; s < cells.n_cells(); ++s) total += cells.measure[s];
///
/// @param cells  whole cells, face s that of site s. An edge counts as a side if it is longer than
///               kShortEdge h (valence.hpp); those on walls count.
CellTable cell_table(const PeriodicMesh& cells);

}  // namespace pcvt::plane
