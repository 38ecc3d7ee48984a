#pragma once

#include "io/tiles/encoded_file.hpp"
#include "io/tiles/tile_file.hpp"

namespace pcvt {

/// The tile in a glTF 2.0 file, `.gltf` or `.glb` by its first bytes, as encode_gltf() describes
/// it.
///
/// Faces are the triangles of the file. The site of a triangle of a cell comes from _CELL_ID or
/// from the node's name `cell_<site>`; without either the file holds a triangle tile, its sites in
/// _SITE_ID if anywhere. Vertex pairs are read, edge pairs are not stored. Lines and points, z,
/// normals and colours are passed over.
///
/// @param lattice  stands in for one that the file lacks.
/// @throws BadFile where the file is damaged, moves its nodes about, keeps data in other files, or
/// has
///         no triangles or no lattice.
TileFile decode_gltf(const std::vector<EncodedFile>& files, const std::optional<Lattice>& lattice);

}  // namespace pcvt
