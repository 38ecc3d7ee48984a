#pragma once

#include "io/gltf/gltf_document.hpp"
#include "mesher/tile/tile.hpp"

namespace pcvt {

/// Reads the positions of the sites and the numbers of periods from extras.periodic into `tile`;
/// leaves a tile without them as it is.
///
/// Example usage:
///   read_site_positions(document, periodic, tile);
/// @param periodic  extras.periodic; null if the file has none.
/// @throws BadFile if they are malformed, or the tile has no sites.
void read_site_positions(const GltfDocument& document, const Json& periodic, Tile& tile);

}  // namespace pcvt
