#pragma once

#include "io/bytes/encoded_file.hpp"
#include "io/forms/tile_file.hpp"

namespace pcvt {

/// Reads the tile in a glTF 2.0 file, which encode_gltf() describes. The first bytes decide between
/// `.gltf` and `.glb`.
///
/// Faces are the triangles of the file. The site of a triangle of a cell comes from
/// extras.periodic.cellTriangles, from the attribute _CELL_ID (with copies of vertices in
/// extras.periodic.vertexCopies) or from the node's name `cell_<site>`; without any of
/// them, the file holds Delaunay triangles, whose sites come from _SITE_ID. Vertex pairs are read;
/// glTF files store no edge pairs. Lines, points, z, normals and colours are skipped,
/// but in files that pcvt wrote they must be as it writes them (gltf_layout.hpp,
/// gltf_attributes.hpp). Nodes may have translations, the same for all triangles:
/// TileFile::translation.
///
/// Example usage:
///     const std::vector<EncodedFile> files = {{"tile.glb", read_whole_file("tile.glb")}};
///     const TileFile file = decode_gltf(files, std::nullopt);
///     const TileProof proof = prove_tile(file.tile, file.precision);
///
/// @param lattice  used if the file has no lattice.
/// @throws BadFile if the file is damaged, turns or scales its nodes, keeps data in other files, or
/// has
///                 no triangles or no lattice.
TileFile decode_gltf(const std::vector<EncodedFile>& files,
                     const std::optional<plane::Lattice>& lattice);

}  // namespace pcvt
