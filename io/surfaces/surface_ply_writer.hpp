#pragma once

#include "io/surfaces/surface_list.hpp"
#include "io/tiles/encoded_file.hpp"

namespace pcvt {

/// Encodes surfaces as ASCII PLY with coordinates in double precision. Cells share their points;
/// the property `cell` of a face is its cell, and its colour is that of encode_surface_obj(). Faces
/// of a boundary have their partner and its offset as well. The sites follow as the element `site`.
///
/// Example usage:
///     const SurfaceList list = surface_list(tile, SurfaceForm::kBoundary);
///     const auto files = encode_surface_ply(list, "tile.ply");
std::vector<EncodedFile> encode_surface_ply(const SurfaceList& list, const std::string& path);

}  // namespace pcvt
