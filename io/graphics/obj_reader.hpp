#pragma once

#include <optional>
#include <vector>

#include "io/bytes/encoded_file.hpp"
#include "io/forms/surface_list.hpp"
#include "io/forms/tile_file.hpp"

namespace pcvt {

/// Reads a Wavefront OBJ strictly: `v` (with or without a colour), `f` (v, v/vt, v//vn, v/vt/vn,
/// negative indices) and the comments of encode_obj(). It skips vn vp o g s and all other comments,
/// and refuses every other statement and every z other than 0. In a file with the comments of
/// encode_obj(), texture coordinates and materials must be as encode_obj() writes them
/// (obj_appearance.hpp); in other files they are skipped.
///
/// A NAME.seam.json among `files` must agree with the comments. Where the OBJ has no such comments,
/// because another program wrote it, kind, lattice, pairs and sites come from the sidecar.
///
/// Example usage:
///     const TileFile file = decode_obj({{"tile.obj", read_whole_file("tile.obj")}}, std::nullopt);
///     const TileProof proof = prove_tile(file.tile, file.precision);
///
/// @throws BadFile with the line.
TileFile decode_obj(const std::vector<EncodedFile>& files,
                    const std::optional<plane::Lattice>& lattice);

/// Reads the surfaces in space of an OBJ of encode_obj_mesh(), by the same rules. Groups are the
/// cells. Colours and texture coordinates are not read.
///
/// Example usage:
///     const SurfaceList list = decode_obj_surfaces({"tile.obj", read_whole_file("tile.obj")});
///
/// @throws BadFile naming the file, and the line of a statement.
SurfaceList decode_obj_surfaces(const EncodedFile& obj);

}  // namespace pcvt
