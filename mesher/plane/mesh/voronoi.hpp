#pragma once

#include "mesher/plane/delaunay/periodic_delaunay.hpp"
#include "mesher/plane/mesh/periodic_mesh.hpp"

namespace pcvt::plane {

/// Builds the cells of the periodic Voronoi diagram, or with weights of the power diagram,
/// unwrapped around their sites, with offsets in the user's basis.
///
/// Example usage:
///   const PeriodicDelaunay delaunay(Sites(lattice, uniform_points(lattice, 100, 1)));
///   const PeriodicMesh cells = cell_mesh(delaunay);
///
/// Vertices are circumcentres of Delaunay triangles, or with weights orthocentres of regular ones
/// (the dual), one per orbit; the ends of an edge shorter than kSameVertex h are merged, until no
/// edge is shorter. Two vertices that no edge joins are never merged, however close they are: that
/// would pinch the cell between them. Laws, tested by number:
///   (1) V - E + F = 0, and each edge has two sides.
///   (2) The areas of the cells sum to that of the domain.
///   (3) Each cell is convex, and no other image is nearer to any of its points, in the power
///       distance if there are weights; without weights the cell contains its site.
///   (4) No edge is shorter than kSameVertex h, h = sqrt(area / n).
/// @throws InvalidInput if a cell is so small that fewer than three of its corners remain distinct
///         or that merging tears it.
PeriodicMesh cell_mesh(const PeriodicDelaunay& delaunay);

/// Builds the Delaunay triangles; the vertices are the sites, in their order.
PeriodicMesh triangle_mesh(const PeriodicDelaunay& delaunay);

/// The number of sides of each site's cell, equal to cell_sides() of a cell_mesh but without
/// building it: counts the dual edges longer than kShortEdge h (valence.hpp).
std::vector<int> cell_sides(const PeriodicDelaunay& delaunay);

/// Calls cell_mesh for `kVoronoi` and triangle_mesh for `kDelaunay`.
PeriodicMesh periodic_mesh(const PeriodicDelaunay& delaunay, MeshKind kind);

}  // namespace pcvt::plane
