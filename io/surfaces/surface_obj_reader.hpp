#pragma once

#include "io/surfaces/surface_list.hpp"
#include "io/tiles/encoded_file.hpp"

namespace pcvt {

/// Whether a file says that it is an OBJ of encode_surface_obj().
bool is_surface_obj(const EncodedFile& file);

/// Reads points, faces and comments of an OBJ of encode_surface_obj(). Colours are not read.
///
/// Example usage:
///     const SurfaceList list = decode_surface_obj({"tile.obj", read_whole_file("tile.obj")});
///
/// @throws BadFile with the line.
SurfaceList decode_surface_obj(const EncodedFile& obj);

}  // namespace pcvt
