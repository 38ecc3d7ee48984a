#pragma once

#include "mesher/delaunay/periodic_delaunay.hpp"
#include "mesher/mesh/periodic_mesh.hpp"

namespace pcvt {

/// The cells of the periodic Voronoi diagram, unwrapped round their sites; offsets in the user's
/// basis.
///
/// Vertices are circumcentres of Delaunay triangles (the dual), one an orbit, merged along dual
/// edges shorter than kSameVertex h. Laws, tested by number:
///   (1) V - E + F = 0, and each edge has two sides.
///   (2) The areas of the cells sum to that of the domain.
///   (3) Each cell holds its site, is convex, and no other image is nearer to any point of it.
/// @throws InvalidInput where a cell is so small that its corners merge to fewer than three, or
/// that
///         merging tears it.
PeriodicMesh cell_mesh(const PeriodicDelaunay& delaunay);

/// The Delaunay triangles; vertices are the sites, in their order.
PeriodicMesh triangle_mesh(const PeriodicDelaunay& delaunay);

/// cell_mesh for `kVoronoi`, triangle_mesh for `kDelaunay`.
PeriodicMesh periodic_mesh(const PeriodicDelaunay& delaunay, MeshKind kind);

}  // namespace pcvt
