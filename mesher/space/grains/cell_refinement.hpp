#pragma once

#include "mesher/space/grains/cell_tetrahedra.hpp"

namespace pcvt::space {

/// How dense the inner vertices of a cell become.
struct RefinementChoices {
    /// The target length of edges, length units.
    double size;
    /// The edge of the cubes of the body-centred lattice of first vertices, over `size`; 0: none.
    double lattice_edge = 1.1;
    /// A tetrahedron whose circumradius is this many times the local size is refined.
    double radius = 1.05;
};

/// Inserts the points of a body-centred cubic lattice that lie deep in the cell, where the local
/// size is about that of the cell.
/// @param anchor  a point of the lattice.
void insert_lattice(CellTetrahedra& cell, const RefinementChoices& choices, const Vec3& anchor);

/// Inserts vertices into the tetrahedra that are largest over the local size: in the centre of
/// their sphere, above their triangles on the hull, or in their middle.
///
/// Law, tested by number:
///   (1) The laws of CellTetrahedra hold, and the hull stays.
void refine(CellTetrahedra& cell, const RefinementChoices& choices);

}  // namespace pcvt::space
