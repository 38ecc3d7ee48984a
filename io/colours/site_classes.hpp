#pragma once

#include <span>
#include <utility>
#include <vector>

#include "mesher/plane/tile/tile.hpp"

namespace pcvt {

/// The number of classes that suffices: on a torus, some site of every subgraph has at most six
/// neighbours.
inline constexpr int kSiteClasses = 7;

/// Returns a class 0 ... kSiteClasses - 1 for each face of a tile of cells or grains, and for each
/// vertex of a tile of Delaunay triangles. Faces (vertices) of one site have the same class;
/// neighbouring sites have different classes, across the seam as well. Each class takes about as
/// many sites as every other one.
/// @param site_group  of sites 0 to n - 1 of one period, groups counted from 0: sites of a group
/// have
///                    the same class, and neighbours of different groups have different ones. The
///                    groups are the orbits of a plane group, whose quotient of the torus needs no
///                    more classes than the torus. Empty: each site is a group.
std::vector<int> site_classes(const plane::Tile& tile, std::span<const int> site_group = {});

/// Returns the classes of the nodes 0 ... n - 1 of a graph of neighbours, as site_classes() does.
/// Cells in space may have more than six earlier neighbours; where these have all classes, a cell
/// has one of them.
/// @param pairs  neighbours, in any order.
std::vector<int> classes_of_neighbours(std::vector<std::pair<SiteId, SiteId>> pairs, SiteId n);

}  // namespace pcvt
