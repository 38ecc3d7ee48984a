#pragma once

#include "mesher/space/mesh/cell_complex.hpp"

namespace pcvt::space {

/// Angles below this, in degrees, count against an origin.
inline constexpr double kNarrowAngle = 25;

/// The sum of (25 - a)^2 over the angles a below 25 degrees that the planes u = k of one
/// coordinate u of the lattice make with the cells: dihedral angles, and corners of faces.
///
/// @param axis   0 to 2.
/// @param plane  u of one of the planes, in [0, 1].
double narrow_angles(const Sites& sites, const CellComplex& complex, int axis, double plane);

/// Pieces of cells thinner than this part of h count against an origin.
inline constexpr double kThinPiece = 0.1;

/// The sum of (25 - 250 d / h)^2 over the thin pieces that the planes cut off from cells, d the
/// distance of the farthest corner of the cell from the plane. Faces nearly parallel to a plane
/// make thin pieces without narrow angles.
double thin_pieces(const Sites& sites, const CellComplex& complex, int axis, double plane);

/// Chooses the corner of a box so that its sides cut the cells with few narrow angles and thin
/// pieces: for each axis by itself the position with the smallest sum of narrow_angles() and
/// thin_pieces() of 200, or of 1,000 for more than 200 cells; of those that are equal up to
/// rounding, the one farthest from vertices of the cells.
///
/// Example usage:
///     const CellComplex pieces = cells_in_box(sites, complex, best_box_origin(sites, complex));
///
/// Laws, tested by number:
///   (1) No other of these positions has a smaller sum.
///   (2) The origin lies in the domain at 0.
Vec3 best_box_origin(const Sites& sites, const CellComplex& complex);

}  // namespace pcvt::space
