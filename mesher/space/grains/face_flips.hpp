#pragma once

#include <vector>

#include "mesher/space/grains/cell_tetrahedra.hpp"

namespace pcvt::space {

/// Replaces edges between two triangles of a face by those between their apexes, where the smallest
/// sine of the tetrahedra at the edge in both cells rises. Each triangle changes at most once.
///
/// Laws, tested by number: those of SharedMoves.
///
/// @param surface  the triangles of the face change, the points do not.
void flip_face_edges(const CellComplex& complex, GrainSurface& surface,
                     const std::vector<CellHull>& hulls, std::vector<CellTetrahedra>& cells,
                     int face);

}  // namespace pcvt::space
