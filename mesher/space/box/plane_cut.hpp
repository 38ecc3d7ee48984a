#pragma once

#include <array>
#include <vector>

#include "mesher/space/box/plane_levels.hpp"
#include "mesher/space/mesh/cell_complex.hpp"

namespace pcvt::space {

/// The pieces of cells between parallel planes, while the cells are cut along one axis after the
/// other. Offsets are in the basis of the user, whose lattice takes the place of
/// CellComplex::reduced.
struct CutCells {
    CellComplex complex;
    /// The cell of each piece, ascending.
    std::vector<SiteId> cell = {};
    /// For each piece and axis the number k of its slab: u is between k and k + 1, or the axis is
    /// not cut yet and k is 0.
    std::vector<std::array<int, 3>> slab = {};
    /// For each vertex and axis its level: 2 k on the plane u = k, and 2 k + 1 in slab k. An image
    /// with the offset (i, j, k) adds 2 i, 2 j and 2 k.
    std::vector<std::array<int, 3>> level = {};
};

/// Cuts all cells along the planes on which one coordinate is an integer.
///
/// A level is found once for each vertex; later decisions compare integers, except whether three
/// or more corners of a face bound a part of it in the plane (face_parts.hpp). A new vertex is
/// computed once for each edge and plane, so that the two cells at a face, and the two sides of
/// the box, have the same vertices.
///
/// Law, tested by number:
///   (1) V - E + F - C remains what it was.
///
/// @param axis       of u = lattice.to_lattice(position - origin), 0 to 2.
/// @param near       vertices that lie on a plane.
/// @returns whether the pieces are polyhedra; false where rounding, or faces that are not plane,
///          let a plane cross a face more than twice.
bool cut_along(int axis, const Vec3& origin, const Nearness& near, CutCells& cells);

}  // namespace pcvt::space
