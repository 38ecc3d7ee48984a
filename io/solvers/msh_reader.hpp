#pragma once

#include <optional>
#include <vector>

#include "io/bytes/encoded_file.hpp"
#include "io/forms/tile_file.hpp"

namespace pcvt {

/// Reads an ASCII MSH 4.1 file as pcvt or Gmsh writes it: one entry per line; nodes in the plane
/// z = 0; triangles with three nodes, or with six nodes and straight sides; lines and points, which
/// do not become faces.
///
/// Vertex pairs come from $Periodic, whose affine maps must be translations. In a file with the
/// $Comments of encode_msh(), edge pairs come from the lines of the curves in $Periodic, sites from
/// $NodeData or $ElementData "cell_id", and the lattice from $Comments; the groups `cell_s` and
/// `grain_boundary` of such a file must agree with the sites. Other sections are skipped;
/// msh_fields() serves to prove them.
///
/// Example usage:
///     const TileFile file = decode_msh({{"tile.msh", read_whole_file("tile.msh")}}, std::nullopt);
///     const TileProof proof = prove_tile(file.tile, file.precision);
///
/// @throws BadFile with the line.
TileFile decode_msh(const std::vector<EncodedFile>& files,
                    const std::optional<plane::Lattice>& lattice);

}  // namespace pcvt
