#pragma once

#include <optional>
#include <vector>

#include "io/tiles/encoded_file.hpp"
#include "io/tiles/tile_file.hpp"

namespace pcvt {

/// Reads a VTU with one piece and ASCII arrays: points in the plane z = 0, and either polygons or
/// triangles, of three nodes or of six with straight sides. Points of type Float32 make the tile
/// one of single precision.
///
/// The lattice, the vertex pairs and the sites come from the arrays that encode_vtu() writes, where
/// they are there: a file that lacks PeriodicPointIds stores no pairs. Other arrays are passed
/// over. Edge pairs have no place in a VTU.
/// @throws BadFile with the line.
TileFile decode_vtu(const std::vector<EncodedFile>& files, const std::optional<Lattice>& lattice);

}  // namespace pcvt
