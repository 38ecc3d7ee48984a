#pragma once

#include "mesher/mesh/periodic_mesh.hpp"

namespace pcvt {

/// The cells without their short edges: each edge orbit shorter than `shortest` is shrunk to one
/// vertex in its middle, the shortest first, until none is left that may go.
///
/// An edge may go where every cell round it stays a simple polygon of three corners or more that
/// keeps half of its area or more. Laws, tested by number:
///   (1) The result is a mesh of the same torus by the same faces in the same frames:
///       V - E + F = 0, and the areas sum to that of the domain.
///   (2) Each edge left that is shorter than `shortest` could not go.
///   (3) No vertex of an edge that stays moves if it lies on no edge that goes.
///
/// @param cells     whole cells (`kVoronoi`).
/// @param shortest  length units; 0 leaves the mesh as it is.
PeriodicMesh without_short_edges(const PeriodicMesh& cells, double shortest);

}  // namespace pcvt
