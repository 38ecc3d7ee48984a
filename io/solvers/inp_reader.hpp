#pragma once

#include <optional>
#include <vector>

#include "io/bytes/encoded_file.hpp"
#include "io/forms/tile_file.hpp"

namespace pcvt {

/// Reads the mesh of an Abaqus or CalculiX input: *NODE in the plane z = 0, *ELEMENT with triangles
/// (CPE3, CPS3, and CPE6, CPS6 with straight sides) or one layer of wedges over them (C3D6, C3D15),
/// the sets `CELL_s`, and the comments of encode_inp(). It skips other cards.
///
/// Vertex pairs come from *EQUATION, in a file with the node sets CONTROL_1 and CONTROL_2. Each
/// tied node must have one equation per direction, in the form that encode_inp() writes and with
/// one translation for both, and its master must not be tied itself. The format has no edge pairs.
///
/// Example usage:
///     const TileFile file = decode_inp({{"tile.inp", read_whole_file("tile.inp")}}, std::nullopt);
///     const TileProof proof = prove_tile(file.tile, file.precision);
///
/// @throws BadFile with the line.
TileFile decode_inp(const std::vector<EncodedFile>& files,
                    const std::optional<plane::Lattice>& lattice);

}  // namespace pcvt
