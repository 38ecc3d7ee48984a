#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "mesher/plane/tile/tile.hpp"

namespace pcvt {

/// The seam of a tile without its geometry, as the companion NAME.seam.json of NAME.obj stores it.
///
///   {"format": "pcvt seam", "version": 1, "kind": "cells" or "triangles",
///    "lattice": [[ax, ay], [bx, by]], "index_base": 0,
///    "vertex_pairs": [[v, w, i, j], ...], "edge_pairs": [[v0, v1, w0, w1, i, j], ...],
///    "sites": [s, ...]}
///
/// Vertices count from 0 in the order of the OBJ's `v` lines. Cells and grains have one site per
/// face, in the order of the `f` lines; Delaunay triangles have one site per vertex.
///
/// Example usage:
///     const Seam seam = decode_seam("tile.seam.json", read_whole_file("tile.seam.json"));
///     const VertexPair& pair = seam.vertex_pairs.front();
///     const Vec2 translation = seam.lattice.translation(pair.offset);  // from pair.v to pair.w
struct Seam {
    plane::MeshKind kind;
    plane::Lattice lattice;
    std::vector<plane::VertexPair> vertex_pairs = {};
    std::vector<plane::EdgePair> edge_pairs = {};
    std::vector<SiteId> sites = {};
};

/// Encodes the seam with one pair per line; the same tile gives the same bytes.
std::string encode_seam(const plane::Tile& tile);

/// Reads such a file back.
/// @param name  the file's name in messages.
/// @throws BadFile if the text does not have this form.
Seam decode_seam(const std::string& name, std::string_view text);

}  // namespace pcvt
