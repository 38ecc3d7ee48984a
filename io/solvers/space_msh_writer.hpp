#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "io/tiles/encoded_file.hpp"
#include "mesher/space/proof/tetrahedral_proof.hpp"

namespace pcvt {

/// The comment of a file of tetrahedra.
inline constexpr std::string_view kTetrahedraComment = "pcvt kind tetrahedra";

/// Encodes a tile of Delaunay tetrahedra as Gmsh MSH 4.1 in ASCII with double precision.
///
/// Node v + 1 is point v, element t + 1 is tetrahedron t; triangles of the seam have the numbers
/// after them. Entities: as seam_entities() finds them, and one volume. Points and curves have no
/// elements: they would be in no group, and meshio reads a file in which all elements or none are.
/// Physical groups: `seam_I_J_K`, the surface that I a + J b + K c takes to its partner, and
/// `domain`, all tetrahedra. $Periodic lists each surface with a negative offset, and each curve
/// and point that is not a master, with slave = master + translation. Each link goes from a master
/// to an image with a larger offset, and tied_frames() laid the tile out, so that a program finds
/// every orbit which keeps one link a node, whichever, or links the surfaces alone. $NodeData
/// "cell_id" holds the site of each node. $Comments hold the kind and the nine numbers of the
/// lattice.
///
/// Example usage:
///     for (const EncodedFile& file : encode_space_msh(mesh, "tile.msh")) {
///         output.stage(file.path, file.bytes);
///     }
///
/// @throws NotATile as prove_tetrahedra().
std::vector<EncodedFile> encode_space_msh(const space::TetrahedralMesh& mesh,
                                          const std::string& path);

}  // namespace pcvt
