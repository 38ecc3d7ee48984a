#pragma once

#include "io/bytes/encoded_file.hpp"
#include "io/forms/file_tetrahedra.hpp"

namespace pcvt {

/// Returns whether an MSH file holds tetrahedra of pcvt.
bool holds_msh_tetrahedra(const EncodedFile& msh);

/// Reads the lattice, the nodes, their sites, the tetrahedra and the phases of an MSH file as
/// encode_msh() writes it. The offsets of the points follow from their positions.
///
/// Example usage:
///     const TetrahedralTile tile = decode_msh_tetrahedra({"t.msh", read_whole_file("t.msh")});
///     const TetrahedralProof proof = prove_tetrahedra(tile.mesh);
///
/// @throws BadFile with the line.
TetrahedralTile decode_msh_tetrahedra(const EncodedFile& msh);

/// Compares the entities, groups, triangles, curves and links of a file with those that
/// encode_msh() gives for its tetrahedra.
/// @throws BadFile  naming the file, the line and both words.
void compare_msh_tetrahedra(const EncodedFile& msh, const TetrahedralTile& tile);

}  // namespace pcvt
