#pragma once

#include "mesher/finite_volume/extruded_mesh.hpp"

namespace pcvt {

/// Reconstructs the tile below an extruded mesh: the faces from the patch "back", the edge pairs
/// from the patches of the seam, and the walls with their edges from theirs. It inverts
/// extruded_mesh, except that the vertex pairs are left empty.
///
/// Example usage:
///   const plane::Tile tile = extruded_base(extruded, lattice, plane::MeshKind::kVoronoi);
///   const TileProof proof = prove_tile(tile, Precision::kDouble);
///   compare_edge_pairs(tile, proof);
///   compare_wall_edges(tile, proof);
///
/// The function trusts nothing in `extruded`. It proves that indices are valid and that the laws of
/// extruded meshes hold, under their numbers. The others then prove that the faces are a tile, the
/// edge pairs its seam, and the edges on walls all of them.
/// @throws NotATile naming the law and the face, point or patch (from 0).
plane::Tile extruded_base(const FiniteVolumeMesh& extruded, const plane::Lattice& lattice,
                          plane::MeshKind kind);

}  // namespace pcvt
