#pragma once

#include <string>
#include <vector>

#include "io/bytes/encoded_file.hpp"
#include "io/forms/file_options.hpp"
#include "mesher/plane/tile/tile.hpp"

namespace pcvt {

/// Encodes a tile as one HTML page that needs no other file and no network. A browser shows the
/// tile in it, repeats it, and names the cell and the partner edges under the pointer.
///
/// The page holds the tile as JSON in the element `data`:
///   {"format": "pcvt page", "version": 1, "name": "tile.html", "colouring": "sides",
///    "kind": "cells" | "triangles" | "grains", "lattice": [[ax, ay], [bx, by]],
///    "points": [x, y, ...], "faces": [[v, ...], ...], "sites": [s, ...], "sides": [n, ...],
///    "site_points": [x, y, ...], "densities": [d, ...], "classes": [k, ...],
///    "phases": ["name", ...], "site_phases": [p, ...], "pole_colours": ["#rrggbb", ...],
///    "orbits": [o, ...], "orbit_classes": [k, ...],
///    "vertex_pairs": [[v, w, i, j], ...], "edge_pairs": [[v0, v1, w0, w1, i, j], ...]}
///
/// `sites` has one entry for each face of cells and grains and for each vertex of triangles;
/// `sides` are the sides of each face's cell, or the valence of each vertex. `site_points` are
/// those of cells; it is empty otherwise. `densities` are those at sites 0 to n - 1 of one period,
/// `site_phases`, `orbits` and `pole_colours`, those of orientations, the same, where there are
/// some; `classes` are the colours that differ between neighbours, one for each face of cells and
/// grains, and `orbit_classes` those of orbits. Laws, tested by number:
///   (1) The JSON gives points, faces, sites and pairs back exactly.
///   (2) The data holds no '<', so that no name can end the element.
///   (3) The page without its data is smaller than 300 KB and names no address of a network.
///
/// Example usage:
///     for (const EncodedFile& file : encode_html(tile, {}, "tile.html")) {
///         output.stage(file.path, file.bytes);
///     }
///
/// @throws InternalError if a coordinate is not finite.
std::vector<EncodedFile> encode_html(const plane::Tile& tile, const FileOptions& options,
                                     const std::string& path);

}  // namespace pcvt
