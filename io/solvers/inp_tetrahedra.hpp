#pragma once

#include <string>
#include <vector>

#include "io/bytes/encoded_file.hpp"
#include "io/forms/file_options.hpp"
#include "io/forms/file_tetrahedra.hpp"

namespace pcvt {

/// Encodes tetrahedra C3D4, or C3D10 for order 2, as an Abaqus or CalculiX input with the equations
/// of inp_text(); with options.materials also with the sections of their cells, and with
/// options.job as a job that runs as it is.
///
/// Element sets: `EALL`; of tetrahedra inside of cells `CELL_s`. Node sets: `NALL`;
/// `GRAIN_BOUNDARY`, `TRIPLE_LINES` and `QUADRUPLE_POINTS`, the nodes at which two, three and four
/// cells meet, or more; `seam_I_J_K`, the nodes that I a + J b + K c takes to their partners; in a
/// box also those of box_sets(), in the same order on partners;
/// `FIXED`, one representative; `CONTROL_1`, `CONTROL_2` and `CONTROL_3`. Surfaces:
/// `GRAIN_BOUNDARY_SIDES`, each triangle between cells once; `PHASE_A_TO_B`, the sides of elements
/// of phase A at phase B.
///
/// Example usage:
///     for (const EncodedFile& file : encode_tetrahedra_inp(mesh, {}, "tile.inp")) {
///         output.stage(file.path, file.bytes);
///     }
///
/// @throws InvalidInput   if 20 characters cannot hold the numbers of the tile.
/// @throws InternalError  if a coordinate is not finite.
std::vector<EncodedFile> encode_tetrahedra_inp(const space::TetrahedralMesh& mesh,
                                               const FileOptions& options, const std::string& path);

/// Returns whether an input holds tetrahedra of pcvt.
bool holds_inp_tetrahedra(const EncodedFile& inp);

/// Reads the lattice, the nodes, the tetrahedra, their cells and materials, and the orbits of the
/// nodes, which follow from the equations.
///
/// Example usage:
///     const TetrahedralTile tile = decode_inp_tetrahedra({"t.inp", read_whole_file("t.inp")});
///     const TetrahedralProof proof = prove_tetrahedra(tile.mesh);
///
/// @throws BadFile with the line.
TetrahedralTile decode_inp_tetrahedra(const EncodedFile& inp);

/// Compares the elements, sets, surfaces, equations and sections of a file with those that
/// encode_tetrahedra_inp() gives for its tetrahedra.
/// @throws BadFile  naming the file, the line and both words.
void compare_inp_tetrahedra(const EncodedFile& inp, const TetrahedralTile& tile);

}  // namespace pcvt
