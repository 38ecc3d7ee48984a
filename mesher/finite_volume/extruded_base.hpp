#pragma once

#include "mesher/finite_volume/extruded_mesh.hpp"

namespace pcvt {

/// The tile that a extruded stands on, as its back plane and its patches tell it: faces from the
/// patch "back", each pair of edges from the patches of the seam. The inverse of extruded_mesh but
/// for the pairs of vertices, which are left empty.
///
/// Nothing in `extruded` is believed: indices, runs of faces, the order of the inner faces, and the
/// laws of ExtrudedMesh by their numbers are proved here; that the faces are a tile and the pairs
/// its seam is left to prove_tile and compare_edge_pairs.
/// @throws NotATile naming the law and the face, point or patch (from 0).
Tile extruded_base(const ExtrudedMesh& extruded);

}  // namespace pcvt
