#pragma once

#include "io/surfaces/surface_list.hpp"
#include "io/tiles/encoded_file.hpp"

namespace pcvt {

/// Whether a file says that it is a PLY of encode_surface_ply().
bool is_surface_ply(const EncodedFile& file);

/// Reads points, faces, sites and pairs of a PLY of encode_surface_ply(). Colours are not read.
///
/// Example usage:
///     const SurfaceList list = decode_surface_ply({"tile.ply", read_whole_file("tile.ply")});
///
/// @throws BadFile with the line.
SurfaceList decode_surface_ply(const EncodedFile& ply);

}  // namespace pcvt
