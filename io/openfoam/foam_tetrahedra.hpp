#pragma once

#include <string>
#include <vector>

#include "io/bytes/encoded_file.hpp"
#include "io/forms/file_tetrahedra.hpp"

namespace pcvt {

/// Encodes tetrahedra inside of cells as a case in which each tetrahedron is a cell, with a
/// BeltramiFlow at the centroids. The tetrahedra of cell s are the zone cell_s, those of a phase
/// the zone phase_NAME. Nodes in the middle of edges are left out.
///
/// Example usage:
///     const std::vector<EncodedFile> files = encode_foam_tetrahedra(mesh, nullptr, "t.foam");
///     const TetrahedralTile tile = decode_foam_tetrahedra(files, 0);
///
/// @pre mesh.cell is not empty, and rises.
/// @param materials  of the cells, or nullptr.
std::vector<EncodedFile> encode_foam_tetrahedra(const space::TetrahedralMesh& mesh,
                                                const CellMaterials* materials,
                                                const std::string& folder);

/// Whether the files of a case hold tetrahedra inside of cells.
bool is_foam_of_tetrahedra(const std::vector<EncodedFile>& files);

/// Returns the tetrahedra with their corners in the one order that a case determines: rising
/// numbers, or rising ones with the last two exchanged.
space::TetrahedralMesh with_sorted_corners(space::TetrahedralMesh mesh);

/// Reads the tetrahedra of a case, with sorted corners; only files in constant/polyMesh are read.
/// @param tolerance  within which partners on the seam agree at least, length units.
/// @throws BadFile   a file is missing or is not in OpenFOAM's ASCII format, or a cell is not a
///                   tetrahedron.
/// @throws NotATile  a number refers to something that does not exist, or a boundary face has no
///                   partner.
TetrahedralTile decode_foam_tetrahedra(const std::vector<EncodedFile>& files, double tolerance);

/// Proves the order and the orientation of the faces and of their points, and compares all files of
/// a case with those that follow from its mesh.
/// @throws BadFile, NotATile
void compare_foam_tetrahedra(const std::vector<EncodedFile>& files, const TetrahedralTile& tile,
                             double tolerance);

}  // namespace pcvt
