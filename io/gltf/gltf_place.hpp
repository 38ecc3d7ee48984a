#pragma once

#include "mesher/plane/tile/tile.hpp"

namespace pcvt {

/// Returns the translation of the node `tile` in a glTF file, to which positions are relative, so
/// that float32 holds those of a distant tile: the whole periods that the tile lies away from 0, if
/// these are more than 8 along a period vector; else 0.
///
/// Example usage:
///   const Vec2 translation = gltf_translation(tile);
///   const Tile near = moved_by(tile, -translation);
plane::Vec2 gltf_translation(const plane::Tile& tile);

/// Returns the tile with its points, its sites and all images of them moved.
plane::Tile moved_by(plane::Tile tile, const plane::Vec2& way);

}  // namespace pcvt
