#pragma once

#include "io/bytes/encoded_file.hpp"
#include "io/forms/space_tile.hpp"

namespace pcvt {

/// Returns whether a VTU holds polyhedra.
bool holds_vtu_polyhedra(const EncodedFile& vtu);

/// Reads a VTU of polyhedra as encode_vtu() writes it. Joins the cells by their positions, and
/// compares the orbits of the points, the numbers of the faces and the volumes that the file states
/// with those of the cells.
///
/// Example usage:
///     const SpaceTile tile = decode_vtu_polyhedra({"tile.vtu", read_whole_file("tile.vtu")});
///     const PolyhedralProof proof = prove_polyhedra(tile.mesh);
///
/// @param tolerance  within which partners on the seam agree at least, length units.
/// @throws BadFile   the text does not have that form, or contradicts its cells.
/// @throws NotATile  a face has no partner, or more than two cells.
SpaceTile decode_vtu_polyhedra(const EncodedFile& vtu, double tolerance = 0);

}  // namespace pcvt
