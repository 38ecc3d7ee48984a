#pragma once

#include <vector>

#include "io/bytes/encoded_file.hpp"
#include "io/forms/space_tile.hpp"
#include "io/openfoam/foam_case.hpp"

namespace pcvt {

/// Returns the case of a tile of polyhedra, with a BeltramiFlow at the centroids of the cells. Cell
/// s is the cell of site s. The notes hold the period vectors, the images of the sites and their
/// weights, the length of removed edges and the materials. The cells of each phase are the zone
/// phase_NAME. The tile must outlive the case.
///
/// Example usage:
///     const std::vector<EncodedFile> files = encode_foam(foam_case(tile), "tile.foam");
FoamCase foam_case(const SpaceTile& tile);

/// Returns whether the files of a case hold a tile of polyhedra, and not one layer of prisms.
bool is_foam_of_polyhedra(const std::vector<EncodedFile>& files);

/// Reads the tile of a case of polyhedra; only files in constant/polyMesh are read. The orbits of
/// the points follow from the pairs of boundary faces, names and separations of the patches from
/// their offsets.
///
/// Example usage:
///     const SpaceTile tile = decode_foam_polyhedra(files);
///     const PolyhedralProof proof = prove_polyhedra(tile.mesh);
///
/// @param tolerance  within which partners on the seam agree at least, length units.
/// @throws BadFile   a file is missing or is not in OpenFOAM's ASCII format.
/// @throws NotATile  a number refers to something that does not exist, or a boundary face has no
///                   partner.
SpaceTile decode_foam_polyhedra(const std::vector<EncodedFile>& files, double tolerance = 0);

}  // namespace pcvt
