#pragma once

#include <optional>
#include <vector>

#include "io/tiles/encoded_file.hpp"
#include "io/tiles/tile_file.hpp"

namespace pcvt {

/// Reads an ASCII PLY 1.0 strictly: one element a line, vertices with x and y (and z = 0), faces
/// with the list vertex_indices or vertex_index; other properties and elements are passed over.
/// Coordinates declared `float` make the tile one of single precision.
///
/// Vertex pairs come from orbit, offset_i and offset_j, where all three are there; edge pairs have
/// no place in a PLY.
/// @throws BadFile with the line.
TileFile decode_ply(const std::vector<EncodedFile>& files, const std::optional<Lattice>& lattice);

}  // namespace pcvt
