#pragma once

#include "io/gltf/gltf_document.hpp"
#include "mesher/plane/tile/tile.hpp"

namespace pcvt {

/// Reads the notes of the sites (io/forms/site_notes.hpp) from extras.periodic into `tile`; leaves
/// the tile as it is if there are none.
///
/// Example usage:
///   read_site_notes(document, periodic, tile);
/// @param periodic  extras.periodic; null if the file has none.
/// @throws BadFile if they are malformed, or the tile has no sites.
void read_site_notes(const GltfDocument& document, const Json& periodic, plane::Tile& tile);

}  // namespace pcvt
