#pragma once

#include "io/space/space_tile.hpp"
#include "io/tiles/encoded_file.hpp"

namespace pcvt {

/// Returns whether a VTU holds polyhedra.
bool holds_polyhedra(const EncodedFile& vtu);

/// Reads a VTU as encode_space_vtu() writes it. Joins the cells by their positions, and compares
/// the orbits of the points, the numbers of the faces and the volumes that the file states with
/// those of the cells.
///
/// Example usage:
///     const SpaceTile tile = decode_space_vtu({"tile.vtu", read_whole_file("tile.vtu")});
///     const PolyhedralProof proof = prove_polyhedra(tile.mesh);
///
/// @param tolerance  within which partners on the seam agree at least, length units.
/// @throws BadFile   the text is no such file, or states something else of its cells.
/// @throws NotATile  a face has no partner, or more than two cells.
SpaceTile decode_space_vtu(const EncodedFile& vtu, double tolerance = 0);

}  // namespace pcvt
