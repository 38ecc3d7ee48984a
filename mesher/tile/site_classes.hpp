#pragma once

#include <vector>

#include "mesher/tile/tile.hpp"

namespace pcvt {

/// The number of classes that suffices: on a torus, some site of every subgraph has at most six
/// neighbours.
inline constexpr int kSiteClasses = 7;

/// Returns a class 0 ... kSiteClasses - 1 for each face of a tile of cells or grains, and for each
/// vertex of a tile of Delaunay triangles. Faces (vertices) of one site have the same class;
/// neighbouring sites have different classes, across the seam as well. Each class takes about as
/// many sites as every other one.
std::vector<int> site_classes(const Tile& tile);

}  // namespace pcvt
