#pragma once

#include "io/bytes/encoded_file.hpp"
#include "io/forms/file_tetrahedra.hpp"

namespace pcvt {

/// Returns whether a VTU states three period vectors and holds no polyhedra.
bool holds_vtu_tetrahedra(const EncodedFile& vtu);

/// Reads a VTU of tetrahedra as encode_vtu() writes it, also after another program has written it
/// again. The offsets of the points follow from their positions; those that the file states, and
/// the points of which they are images, are compared with these.
///
/// Example usage:
///     const TetrahedralTile tile = decode_vtu_tetrahedra({"t.vtu", read_whole_file("t.vtu")});
///     const TetrahedralProof proof = prove_tetrahedra(tile.mesh);
///
/// @throws BadFile with the line.
TetrahedralTile decode_vtu_tetrahedra(const EncodedFile& vtu);

/// Compares a file that pcvt wrote with the one that encode_vtu() gives for its tetrahedra; accepts
/// files of other programs.
/// @throws BadFile  naming the line.
void compare_vtu_tetrahedra(const EncodedFile& vtu, const TetrahedralTile& tile);

}  // namespace pcvt
