#pragma once

#include "io/tiles/encoded_file.hpp"
#include "mesher/space/tile/tile_surface.hpp"

namespace pcvt {

/// Whether a file has the properties of an OpenMesh file of encode_surface_om().
bool is_surface_om(const EncodedFile& file);

/// Reads a file of encode_surface_om().
///
/// Example usage:
///     const TileSurface surface = decode_surface_om({"tile.om", read_whole_file("tile.om")});
///
/// @throws BadFile naming the file.
space::TileSurface decode_surface_om(const EncodedFile& om);

}  // namespace pcvt
