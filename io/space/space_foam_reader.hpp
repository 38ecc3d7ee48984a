#pragma once

#include <vector>

#include "io/space/space_tile.hpp"
#include "io/tiles/encoded_file.hpp"

namespace pcvt {

/// Returns whether the files of a case hold a tile of polyhedra, and not one layer of prisms.
bool is_space_case(const std::vector<EncodedFile>& files);

/// Reads the mesh of a case as encode_space_foam() writes it; only files in constant/polyMesh are
/// read. The orbits of the points follow from the pairs of boundary faces.
///
/// Example usage:
///     const SpaceTile tile = decode_space_foam(files);
///     const PolyhedralProof proof = prove_polyhedra(tile.mesh);
///
/// @param tolerance  within which partners on the seam agree at least, length units.
/// @throws BadFile   a file is missing or is not in OpenFOAM's ASCII format, or a number refers to
///                   something that does not exist.
/// @throws NotATile  a boundary face has no partner.
SpaceTile decode_space_foam(const std::vector<EncodedFile>& files, double tolerance = 0);

/// Compares the files of a case with those that encode_space_foam() gives for its tile: the words
/// of the mesh, the solver's settings and the initial state. Files outside of constant/polyMesh
/// from which the user removed the note of pcvt are skipped.
/// @throws BadFile  naming the file, the line and both words.
void compare_space_case(const std::vector<EncodedFile>& files, const SpaceTile& tile);

}  // namespace pcvt
