#pragma once

#include "mesher/base/error.hpp"
#include "mesher/space/mesh/cell_complex.hpp"

namespace pcvt::space {

/// The planes of a box cut a face of a cell in a way that rounding does not resolve.
class UncutCells : public LimitExceeded {
   public:
    using LimitExceeded::LimitExceeded;
};

/// The greatest distance from a side of the box, a part of h, at which vertices are snapped to it
/// where cells are filled with tetrahedra. Without that, a side that passes through faces of cells
/// up to rounding, or up to the residual of an optimisation, would cut off plates and needles
/// thinner than tetrahedra can be.
inline constexpr double kSnappedVertices = 1e-4;

/// Cuts cells along the sides of the box at `origin` and along those of all its images.
///
/// The result is a complex of the same torus, whose cells are the pieces. Everything that is
/// computed from it once for each face therefore agrees on opposite sides of the box. Each piece
/// lies inside of the box, in its frame.
///
/// Example usage:
///     const CellComplex pieces = cells_in_box(sites, complex, origin);
///     PolyhedralMesh mesh = polyhedral_mesh(sites, pieces);
///     put_on_sides(origin, mesh);
///
/// Laws, tested by number:
///   (1) V - E + F - C = 0, and the faces of each piece close.
///   (2) The pieces of a cell are adjacent in number, and their volumes sum to its own.
///   (3) Each piece of convex cells is the part of its cell inside of the box.
///   (4) The pieces do not change when a site or the origin moves by a translation of the lattice.
/// Cost: n log n for n cells.
///
/// @param complex  of these sites, also without its short edges.
/// @param origin   the corner of the box, length units.
/// @param snapped  vertices nearer to a side than this part of h are moved to it, except where an
///                 edge or a whole face would almost vanish (Nearness::snapped); faces bend by as
///                 much, and law (3) holds up to it. A face of which only some corners are that
///                 near may get a part in the side.
/// @throws UncutCells  naming the side of the box.
CellComplex cells_in_box(const Sites& sites, const CellComplex& complex, const Vec3& origin,
                         double snapped = 0);

}  // namespace pcvt::space
