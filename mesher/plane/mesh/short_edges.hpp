#pragma once

#include <vector>

#include "mesher/plane/mesh/walled_mesh.hpp"

namespace pcvt::plane {

/// Removes short edges from cells: shrinks each edge orbit shorter than `shortest` to one vertex in
/// its middle, the shortest first, until no further edge may be removed.
///
/// Example usage:
///   const PeriodicMesh cells = cell_mesh(delaunay);
///   const double h = std::sqrt(cells.lattice.area() / cells.n_faces());
///   const PeriodicMesh smooth = without_short_edges(cells, 0.1 * h);
///
/// An edge may be removed if every cell around it remains a simple polygon with at least three
/// corners and keeps at least half of its area. Laws, tested by number:
///   (1) The result is a mesh of the same torus with the same faces in the same frames:
///       V - E + F = 0, and the areas sum to that of the domain.
///   (2) No remaining edge shorter than `shortest` may be removed.
///   (3) A vertex moves only if it lies on a removed edge.
///   (4) A vertex of k cells lies at the mean of the circumcentres of the k - 2 Delaunay triangles
///       that join their sites.
///   (5) No vertex that stays lies on a removed edge.
///
/// @param cells     whole cells (`kVoronoi`).
/// @param shortest  length units; 0 leaves the mesh as it is.
/// @param still     for each vertex whether it stays; empty: none does.
PeriodicMesh without_short_edges(const PeriodicMesh& cells, double shortest,
                                 std::vector<bool> still = {});

/// The same for a mesh between walls (mesh_between_walls()), as if its mirror images lost the same
/// edges at the same time: vertices on walls stay there. The `opposite` of the result is empty.
/// @param between  whole cells, or halves of cells whose sites lie on walls.
PeriodicMesh without_short_edges(const PeriodicMesh& between, double shortest,
                                 const WalledDomain& domain, std::vector<bool> still = {});

}  // namespace pcvt::plane
