#pragma once

#include "mesher/plane/mesh/periodic_mesh.hpp"

namespace pcvt::plane {

/// No cell is cut, or cells are cut along the parallelogram of the period vectors.
enum class Outline { kWhole, kBox };

/// Computes the `whole` outline: for each face, the offset at which it is placed in the tile.
///
/// Example usage:
///   const PeriodicMesh cells = cell_mesh(delaunay);
///   const std::vector<Offset> placement = whole_outline(cells, {0, 0});
///   const Offset at = placement[cells.corner_face[c]];
///   const Vec2 corner = cells.point(c) + cells.lattice.translation(at);
///
/// The union of the placed faces is a disc, and no face is cut. A face is placed so that its
/// centroid lies in the Domain at `origin` (mesher/plane/geometry/domain.hpp). A face whose place
/// there would pinch or disconnect the disc takes the nearest place where it does not.
/// @param mesh  its edges on walls, if any, have the opposite -1.
std::vector<Offset> whole_outline(const PeriodicMesh& mesh, const Vec2& origin);

}  // namespace pcvt::plane
