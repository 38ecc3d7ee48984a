#pragma once

#include <string>
#include <vector>

#include "io/bytes/encoded_file.hpp"
#include "io/forms/file_options.hpp"
#include "io/forms/surface_mesh.hpp"
#include "mesher/plane/tile/tile.hpp"

namespace pcvt {

/// Encodes polygons as ASCII PLY 1.0. Kind and notes are comments that begin with `pcvt`; those
/// with a row a point, a face or a site are properties of the elements `vertex`, `face` and `site`.
/// Indices count from 0.
///
/// Example usage:
///     const auto files = encode_ply_mesh(surface_mesh(list, SeamForm::kColumns), "tile.ply");
///
/// @throws InternalError if a coordinate is not finite.
std::vector<EncodedFile> encode_ply_mesh(const SurfaceMesh& mesh, const std::string& path);

/// Encodes a tile by encode_ply_mesh() with double coordinates and z = 0. Cells and grains have
/// coloured faces, by the number of sides; Delaunay triangles have coloured vertices, by the
/// valence.
///
/// Comments hold the lattice and the kind. Each vertex stores its orbit, the smallest index of a
/// vertex on it, and its offset: position = position(orbit) + offset_i a + offset_j b. `site` is a
/// property of faces (cells and grains) or of vertices (Delaunay triangles). Where the tile has the
/// positions of its sites, a third element `site` stores x and y of site 0, 1, ...: those of the
/// image at the first face (vertex) that names the site.
///
/// With options.single_precision, coordinates are 32-bit floats, and cells are fans of triangles of
/// their site, because viewers such as three.js draw no polygon of more than four corners.
///
/// Example usage:
///     for (const EncodedFile& file : encode_ply(tile, {}, "tile.ply")) {
///         output.stage(file.path, file.bytes);
///     }
///
/// @throws InternalError if a coordinate is not finite.
/// @throws InvalidInput  naming the path if float32 cannot hold the tile.
std::vector<EncodedFile> encode_ply(const plane::Tile& tile, const FileOptions& options,
                                    const std::string& path);

}  // namespace pcvt
