#pragma once

#include <array>
#include <vector>

#include "mesher/plane/tile/tile.hpp"

namespace pcvt::plane {

/// A position in a texture as graphics programs store it: u to the right, v upwards, 1 is one
/// copy of the texture.
using TextureCoordinate = std::array<float, 2>;

/// Returns the whole numbers of periods, along a and b, that a tile lies away from 0; 0 along a
/// period vector along which these are at most 8.
Vec2 distant_periods(const Tile& tile);

/// Returns for each vertex of a tile its lattice coordinates (u, v), which lay one copy of a
/// texture on one domain: position = u a + v b. They are not wrapped, so that a repeating texture
/// has no seam.
///
/// For a tile more than 8 periods away from 0, all vertices lose the same whole numbers of periods.
/// Laws, tested by number:
///   (1) For each vertex pair, the coordinates of w are exactly those of v plus the offset, also
///       when computed in float32.
///   (2) 1 - v is exact in float32.
///   (3) u a + v b is the position within 2^-23 of the largest coordinate, up to whole periods.
///
/// Example usage:
///   for (const auto& [u, v] : texture_coordinates(tile)) std::printf("vt %g %g\n", u, v);
std::vector<TextureCoordinate> texture_coordinates(const Tile& tile);

}  // namespace pcvt::plane
