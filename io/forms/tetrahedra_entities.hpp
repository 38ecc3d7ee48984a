#pragma once

#include "io/forms/entity_mesh.hpp"

namespace pcvt {

/// Tetrahedra, and the triangles of the seam, with the entities of seam_entities() and one volume.
/// Points and curves have no elements in files: they would be in no group, and meshio reads a file
/// in which all elements or none are. Groups are `seam_I_J_K`, the surface that I a + J b + K c
/// takes to its partner, and `domain`, all tetrahedra; of tetrahedra inside of cells also `cell_s`,
/// the volume of site s, in place of one volume, and `phase_NAME`, the volumes of the cells with
/// that phase. Links: each surface with a negative offset,
/// and each curve and point that is not a master. Each link goes from a master to an image with a
/// larger offset, and tied_frames() laid the tile out, so that a program finds every orbit which
/// keeps one link a node, whichever, or links only the surfaces.
///
/// @param materials  of the cells; null: no phases. Orientations are not stated.
/// @throws NotATile as prove_tetrahedra().
EntityMesh entity_mesh(const space::TetrahedralMesh& mesh,
                       const CellMaterials* materials = nullptr);

}  // namespace pcvt
