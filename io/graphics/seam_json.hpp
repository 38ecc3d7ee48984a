#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "mesher/tile/tile.hpp"

namespace pcvt {

/// The seam of a tile without its geometry: the companion NAME.seam.json of NAME.obj.
///
///   {"format": "pcvt seam", "version": 1, "kind": "cells" or "triangles",
///    "lattice": [[ax, ay], [bx, by]], "index_base": 0,
///    "vertex_pairs": [[v, w, i, j], ...], "edge_pairs": [[v0, v1, w0, w1, i, j], ...],
///    "sites": [s, ...]}
///
/// Vertices are counted from 0 in the order of the OBJ's `v` lines; there is one site a face of a
/// cell tile, in the order of its `f` lines, or one a vertex of a triangle tile.
struct Seam {
    MeshKind kind;
    Lattice lattice;
    std::vector<VertexPair> vertex_pairs;
    std::vector<EdgePair> edge_pairs;
    std::vector<SiteId> sites;
};

/// One pair a line; the same bytes for the same tile.
std::string encode_seam(const Tile& tile);

/// @param name  the file's name in messages.
/// @throws BadFile unless the text is such a seam.
Seam decode_seam(const std::string& name, std::string_view text);

}  // namespace pcvt
