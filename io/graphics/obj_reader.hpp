#pragma once

#include <optional>
#include <vector>

#include "io/tiles/encoded_file.hpp"
#include "io/tiles/tile_file.hpp"

namespace pcvt {

/// Reads a Wavefront OBJ strictly: `v` (with or without a colour), `f` (v, v/vt, v//vn, v/vt/vn,
/// negative indices) and our own comments; vn vt vp o g s usemtl mtllib and other comments are
/// passed over, every other statement is refused, and so is a z that is not 0.
///
/// A NAME.seam.json among `files` must agree with the comments; where the OBJ has none (another
/// program wrote it), the sidecar gives kind, lattice, pairs and sites.
/// @throws BadFile with the line.
TileFile decode_obj(const std::vector<EncodedFile>& files, const std::optional<Lattice>& lattice);

}  // namespace pcvt
