#pragma once

#include "io/gltf/gltf_document.hpp"
#include "mesher/tile/tile.hpp"

namespace pcvt {

/// Reads what extras.periodic states of the sites (io/tiles/site_notes.hpp) into `tile`; leaves a
/// tile without such notes as it is.
///
/// Example usage:
///   read_site_notes(document, periodic, tile);
/// @param periodic  extras.periodic; null if the file has none.
/// @throws BadFile if they are malformed, or the tile has no sites.
void read_site_notes(const GltfDocument& document, const Json& periodic, Tile& tile);

}  // namespace pcvt
