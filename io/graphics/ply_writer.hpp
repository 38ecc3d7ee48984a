#pragma once

#include <string>
#include <vector>

#include "io/tiles/encoded_file.hpp"
#include "mesher/tile/tile.hpp"

namespace pcvt {

/// ASCII PLY 1.0 with double coordinates, z = 0, faces as they are, coloured by the number of sides
/// (cells: faces, triangles: vertices, by their valence). Indices count from 0.
///
/// The lattice and the kind stand in comments. Each vertex tells its orbit, i.e. the vertex with
/// the smallest index on it, and its offset: position = position(orbit) + offset_i a + offset_j b.
/// `site` is a property of faces (cells) or vertices (triangles).
/// @throws InternalError if a coordinate is not finite.
std::vector<EncodedFile> encode_ply(const Tile& tile, const std::string& path);

}  // namespace pcvt
