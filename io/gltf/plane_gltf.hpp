#pragma once

#include "io/bytes/encoded_file.hpp"
#include "io/forms/file_options.hpp"
#include "mesher/plane/tile/tile.hpp"

namespace pcvt {

/// Encodes a tile as glTF 2.0 in one file: `.gltf` with an embedded buffer, or binary `.glb`.
///
/// The scene has a node `tile` with
///
///   extras.periodic = {"lattice": [[ax, ay], [bx, by]], "vertexPairs": [[v, w, i, j], ...]}
///
/// where position(w) = position(v) + i a + j b; v and w are indices into the POSITION accessor of
/// the surface, which all of its triangles share. Where the tile has the positions of its sites,
/// "sitePositions" is the accessor of x and y of site 0, 1, ..., those of the image at the first
/// face (vertex) that names the site, and a tile of several periods has "periods": [columns, rows],
/// one without edges shorter than Tile::short_edges has "shortEdges", one of elongated cells has
/// "metric": [ratio, degrees], and one of power cells has "siteWeights", the accessor of a weight
/// for each site (io/forms/site_notes.hpp).
/// Grains add "kind": "grains". Coordinates are float32; the lattice keeps double precision. A tile
/// more than 8 periods away from 0 gives the node `tile` a translation of whole periods, in double
/// precision, to which all positions are relative (gltf_place.hpp). The children of `tile`:
///
///   GltfNodes::kCells   one node and one material per cell or grain, both named `cell_<site>`
///   GltfNodes::kOne     one node `cells` with one primitive and one material for each
///                       colour, by default `sides_<n>`. extras.periodic.cellTriangles is [[site,
///                       n], ...]: the next n triangles of the node, primitive by primitive, belong
///                       to the site
///   Delaunay triangles  a node `triangles`: colours by valence, sites in _SITE_ID
///   always              a node `outlines`: the edges as lines, lifted by 0.002 of the larger side
///                       of the tile's bounding box
///
/// GltfNodes::kBySize is kCells for up to kMaxCellNodes cells, else kOne; grains are kOne.
/// TEXCOORD_0 is (u, 1 - v) with the lattice coordinates u and v, because glTF's textures begin at
/// the top: a picture shows upright, and as `--density` lays it over the domain.
///
/// Example usage:
///     for (const EncodedFile& file : encode_glb(tile, {}, "tile.glb")) {
///         output.stage(file.path, file.bytes);
///     }
///
/// @throws CoarsePrecision  naming the path if float32 cannot hold the tile.
/// @throws LimitExceeded  naming the path if there are more sites or bytes than glTF can count.
std::vector<EncodedFile> encode_gltf(const plane::Tile& tile, const FileOptions& options,
                                     const std::string& path);
std::vector<EncodedFile> encode_glb(const plane::Tile& tile, const FileOptions& options,
                                    const std::string& path);

}  // namespace pcvt
