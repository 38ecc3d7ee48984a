#pragma once

#include "io/tiles/encoded_file.hpp"
#include "mesher/space/mesh/tetrahedral_mesh.hpp"

namespace pcvt {

/// Returns whether a VTU states three period vectors and holds no polyhedra.
bool holds_vtu_tetrahedra(const EncodedFile& vtu);

/// Reads a VTU as encode_tetrahedra_vtu() writes it, also after another program has written it
/// again. The offsets of the points follow from their positions; those that the file states, and
/// the points of which they are images, are compared with these.
///
/// Example usage:
///     const TetrahedralMesh mesh = decode_tetrahedra_vtu({"t.vtu", read_whole_file("t.vtu")});
///     const TetrahedralProof proof = prove_tetrahedra(mesh);
///
/// @throws BadFile with the line.
space::TetrahedralMesh decode_tetrahedra_vtu(const EncodedFile& vtu);

/// Compares a file that pcvt wrote with the one that encode_tetrahedra_vtu() gives for its
/// tetrahedra; accepts files of other programs.
/// @throws BadFile  naming the line.
void compare_tetrahedra_vtu(const EncodedFile& vtu, const space::TetrahedralMesh& mesh);

}  // namespace pcvt
