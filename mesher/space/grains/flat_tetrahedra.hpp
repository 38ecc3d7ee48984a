#pragma once

#include "mesher/space/grains/cell_tetrahedra.hpp"

namespace pcvt::space {

/// Divides flat tetrahedra: inserts vertices that make the flattest tetrahedron round them less
/// flat. A cell that is thin over the size of its tetrahedra has none of the vertices that
/// refine() adds, so that all its faces, and also tiny triangles at short edges, are joined to one
/// point far away.
///
/// Example usage:
///     refine(cell, choices);
///     divide_flat(cell);
///
/// Law, tested by number:
///   (1) The least CellTetrahedra::flatness() does not fall, and the laws of CellTetrahedra hold.
void divide_flat(CellTetrahedra& cell);

}  // namespace pcvt::space
