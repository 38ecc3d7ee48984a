#pragma once

#include <array>
#include <vector>

#include "io/forms/file_options.hpp"
#include "mesher/space/mesh/polyhedral_mesh.hpp"
#include "mesher/space/mesh/tetrahedral_mesh.hpp"

namespace pcvt {

/// Closed surfaces of triangles, one after the other: those of the cells, in a box of their pieces,
/// or the boundary of the tile.
///
/// Laws, tested by number:
///   (1) Each directed edge of a surface occurs as often as its reverse, and no part of the
///       triangles of a surface, from its first one on, is closed.
///   (2) The volume inside of each surface is above 0, and that of the surfaces of the cells sums
///       to that of the domain.
///   (3) The two sides of a face have the same triangles, traversed in opposite orders; partners on
///       the seam have them too, moved by a translation.
struct ClosedSurfaces {
    SurfaceForm form = SurfaceForm::kCells;
    space::Lattice lattice;
    /// Length units.
    std::vector<space::Vec3> points = {};
    /// On these points, counter-clockwise seen from outside.
    std::vector<std::array<int, 3>> triangles = {};
};

/// Returns the surfaces of polyhedra. Each face becomes the fan of triangles from the corner that
/// leaves the widest ones.
///
/// Example usage:
///     const ClosedSurfaces surfaces = closed_surfaces(tile.mesh, SurfaceForm::kCells);
ClosedSurfaces closed_surfaces(const space::PolyhedralMesh& mesh, SurfaceForm form);

/// Returns the surfaces of the cells that tetrahedra fill.
/// @pre mesh.cell is not empty.
ClosedSurfaces closed_surfaces(const space::TetrahedralMesh& mesh, SurfaceForm form);

}  // namespace pcvt
