#pragma once

#include <vector>

#include "mesher/plane/tile/tile.hpp"

namespace pcvt::plane {

/// For each face of a tile of cells or grains the number of sides of its cell, as
/// cell_sides(const PeriodicMesh&) counts them (mesher/plane/mesh/valence.hpp).
std::vector<int> cell_sides(const Tile& cells);

/// For each vertex of a tile of Delaunay triangles the number of triangles at its orbit: the
/// valence of the site. On a wall their mirror images count as well.
std::vector<int> vertex_valences(const Tile& triangles);

}  // namespace pcvt::plane
