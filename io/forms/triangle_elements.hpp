#pragma once

#include <string>
#include <vector>

#include "mesher/plane/tile/tile.hpp"

namespace pcvt {

/// Requires triangles, for formats of solvers that do not support polygons.
/// @throws InvalidInput `path: what; take the mesh delaunay or grains`, if `kind` has them.
void require_triangles(plane::MeshKind kind, const std::string& path);

/// The cell that each triangle belongs to, by which solvers assign materials.
///
/// The site of the face where it has one. A Delaunay triangle, which lies in three cells, is given
/// to that of the corner nearest to its centroid; a cell may then have no triangle.
std::vector<SiteId> element_cells(const plane::Tile& tile);

/// The vertex whose cell owns the Delaunay triangle f.
int owner_corner(const plane::Tile& tile, int f);

}  // namespace pcvt
