#pragma once

#include <optional>
#include <vector>

#include "io/bytes/encoded_file.hpp"
#include "io/forms/surface_list.hpp"
#include "io/forms/tile_file.hpp"

namespace pcvt {

/// Reads an ASCII PLY 1.0 strictly: one element per line, vertices with x and y (and z = 0), faces
/// with the list vertex_indices or vertex_index. It skips other properties and elements.
/// Coordinates declared as `float` give a tile of single precision.
///
/// Vertex pairs come from the properties orbit, offset_i and offset_j, which a file declares
/// together or not at all; a PLY stores no edge pairs.
///
/// Example usage:
///     const TileFile file = decode_ply({{"tile.ply", read_whole_file("tile.ply")}}, std::nullopt);
///     const TileProof proof = prove_tile(file.tile, file.precision);
///
/// @throws BadFile with the line.
TileFile decode_ply(const std::vector<EncodedFile>& files,
                    const std::optional<plane::Lattice>& lattice);

/// Reads the surfaces in space of a PLY of encode_ply_mesh(), by the same rules. Colours are not
/// read.
///
/// Example usage:
///     const SurfaceList list = decode_ply_surfaces({"tile.ply", read_whole_file("tile.ply")});
///
/// @throws BadFile naming the file, and the line of an element.
SurfaceList decode_ply_surfaces(const EncodedFile& ply);

}  // namespace pcvt
