#pragma once

#include "io/tiles/encoded_file.hpp"
#include "mesher/tile/tile.hpp"

namespace pcvt {

/// Encodes a tile as glTF 2.0 in one file: `.gltf` with an embedded buffer, or binary `.glb`.
///
/// The scene has a node `tile` with
///
///   extras.periodic = {"lattice": [[ax, ay], [bx, by]], "vertexPairs": [[v, w, i, j], ...]}
///
/// where position(w) = position(v) + i a + j b; v and w are indices into the POSITION accessor of
/// the surface. Grains add "kind": "grains". Coordinates are float32; the lattice keeps double
/// precision. The children of `tile`:
///
///   cells, up to kMaxCellNodes  one node and one material per cell, both named `cell_<site>`
///   more cells, and grains      a node `cells`: colours in COLOR_0, sites in _CELL_ID; vertices
///                               0 ... V - 1 are the vertices of the tile, and vertex V + k is a
///                               copy of vertex extras.periodic.vertexCopies[k] for another cell
///   Delaunay triangles          a node `triangles`: colours by valence, sites in _SITE_ID
///   always                      a node `outlines`: the edges as lines, lifted by 0.002 of the
///                               larger side of the tile's bounding box
///
/// Example usage:
///     for (const EncodedFile& file : encode_glb(tile, "tile.glb")) {
///         output.stage(file.path, file.bytes);
///     }
///
/// @throws InvalidInput   naming the path if float32 cannot hold the tile.
/// @throws LimitExceeded  naming the path if there are more sites or bytes than glTF can count.
std::vector<EncodedFile> encode_gltf(const Tile& tile, const std::string& path);
std::vector<EncodedFile> encode_glb(const Tile& tile, const std::string& path);

/// Viewers slow down beyond about this number of nodes.
inline constexpr int kMaxCellNodes = 2000;

}  // namespace pcvt
