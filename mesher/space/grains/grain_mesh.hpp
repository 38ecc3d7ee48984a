#pragma once

#include <array>
#include <vector>

#include "mesher/space/grains/cell_tetrahedra.hpp"
#include "mesher/space/mesh/tetrahedral_mesh.hpp"

namespace pcvt::space {

/// A triangle between two cells.
struct GrainTriangle {
    SiteId cell;
    SiteId neighbour;
    /// Points of the tile, counter-clockwise seen from outside of `cell`, and the same triangle on
    /// points of `neighbour`: these plus the translation by `offset`, which is (0, 0, 0) where the
    /// tile contains both cells side by side.
    std::array<int, 3> points = {};
    std::array<int, 3> partners = {};
    Offset offset = {};
};

/// A tile of tetrahedra inside of whole cells.
///
/// Laws, tested by number:
///   (1) The tetrahedra obey the laws of TetrahedralMesh, with the orbits of nodes as sites: points
///       on the seam are the first point of their orbit plus a translation.
///   (2) The tetrahedra of a cell fill it: their volumes sum to that of the cell.
///   (3) Each triangle of the boundary of a cell is one GrainTriangle, with tetrahedra of both
///       cells.
struct GrainMesh {
    /// `point_site` is the number of the node of which the point is an image: first those of the
    /// faces, vertices of the cells before all others, then those inside of each cell.
    /// Tetrahedra are sorted by their cells.
    TetrahedralMesh tetrahedra;
    std::vector<GrainTriangle> triangles = {};
};

/// Lays the tetrahedra of the cells out as one connected tile of whole cells round the domain.
/// @param origin  the corner of the domain, length units.
GrainMesh grain_mesh(const Sites& sites, const CellComplex& complex, const GrainSurface& surface,
                     const std::vector<CellHull>& hulls, const std::vector<CellTetrahedra>& cells,
                     const Vec3& origin);

}  // namespace pcvt::space
