#pragma once

#include "io/gltf/gltf_document.hpp"
#include "mesher/plane/tile/tile.hpp"

namespace pcvt {

/// Proves that the attributes of a file of pcvt (gltf_layout.hpp) are those that encode_gltf()
/// gives to its tile:
///   - all triangles share one list of vertices, with z = 0 and a normal (0, 0, 1) each;
///   - texture coordinates are (u, 1 - v), within 4 ulps and the change of (u, v) by 4 ulps of the
///     positions;
///   - colours lie between 0 and 1, and vertices of one site have one colour;
///   - the outlines lie above these vertices, all at one height, and are the edges of the tile's
///     faces, each once, where a face is a fan of triangles of one site.
///
/// Example usage:
///   if (is_own_gltf(document)) require_own_attributes(document, tile);
/// @pre require_own_layout() has returned, and `tile` has the triangles of the file.
/// @throws BadFile naming the vertex.
void require_own_attributes(const GltfDocument& document, const plane::Tile& tile);

}  // namespace pcvt
