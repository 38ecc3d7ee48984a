#pragma once

#include <vector>

#include "mesher/plane/tile/tile.hpp"

namespace pcvt::plane {

/// Returns the positions of the sites 0 ... n - 1 of a tile, by which a file proves its site ids:
/// the image of the site to whose cell the first face with this id belongs, or the first vertex
/// with this id. Returns an empty list where the tile does not have its sites, their positions, or
/// the numbers of its periods.
///
/// Example usage:
///   for (const Vec2& p : site_positions(tile)) std::printf("%.17g %.17g\n", p.x(), p.y());
std::vector<Vec2> site_positions(const Tile& tile);

/// Returns the position of the site of the cell that each face of a tile of grains belongs to, as
/// Tile::grain_site_points. Returns an empty list for other tiles and where the tile states no
/// positions.
/// @param images  for each face the image of its site, in the basis of the lattice of the sites.
std::vector<Vec2> grain_site_points(const Tile& tile, const std::vector<Offset>& images);

}  // namespace pcvt::plane
