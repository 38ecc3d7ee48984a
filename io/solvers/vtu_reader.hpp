#pragma once

#include <optional>
#include <vector>

#include "io/bytes/encoded_file.hpp"
#include "io/forms/tile_file.hpp"

namespace pcvt {

/// Reads a VTU with one piece and ASCII arrays: points in the plane z = 0, and either polygons, or
/// triangles with three nodes, or triangles with six nodes and straight sides. Points of type
/// Float32 give a tile of single precision.
///
/// The lattice, the vertex pairs and the sites come from the arrays that encode_vtu() writes; each
/// of them may be absent. Other arrays are skipped. A VTU stores no edge pairs.
///
/// Example usage:
///     const TileFile file = decode_vtu({{"tile.vtu", read_whole_file("tile.vtu")}}, std::nullopt);
///     const TileProof proof = prove_tile(file.tile, file.precision);
///
/// @throws BadFile with the line.
TileFile decode_vtu(const std::vector<EncodedFile>& files,
                    const std::optional<plane::Lattice>& lattice);

}  // namespace pcvt
