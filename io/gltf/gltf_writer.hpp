#pragma once

#include "io/tiles/encoded_file.hpp"
#include "mesher/tile/tile.hpp"

namespace pcvt {

/// A tile as glTF 2.0: `.gltf` with its buffer embedded, `.glb` in binary. One file each.
///
/// The scene is a node `tile` with
///
///   extras.periodic = {"lattice": [[ax, ay], [bx, by]], "vertexPairs": [[v, w, i, j], ...]}
///
/// where position(w) = position(v) + i a + j b, v and w indices of the POSITION accessor of the
/// surface. Coordinates are float32 there; the lattice keeps its doubles. Its children:
///
///   cells, up to kMaxCellNodes  a node and a material a cell, both named `cell_<site>`
///   more cells                  a node `cells`: colours in COLOR_0, sites in _CELL_ID; vertices
///                               0 ... V - 1 are those of the tile, vertex V + k is one more copy,
///                               for another cell, of vertex extras.periodic.vertexCopies[k]
///   triangles                   a node `triangles`: colours by valence, sites in _SITE_ID
///   always                      a node `outlines`: the edges as lines, 0.002 of the size above
///
/// @throws InvalidInput   naming the path where float32 cannot hold the tile.
/// @throws LimitExceeded  naming the path where sites or bytes are more than glTF can count.
std::vector<EncodedFile> encode_gltf(const Tile& tile, const std::string& path);
std::vector<EncodedFile> encode_glb(const Tile& tile, const std::string& path);

/// Viewers slow down beyond about so many nodes.
inline constexpr int kMaxCellNodes = 2000;

}  // namespace pcvt
