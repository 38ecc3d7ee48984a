#pragma once

#include <vector>

#include "mesher/space/mesh/polyhedral_mesh.hpp"

namespace pcvt::space {

/// Polyhedra as files list them: points, and the faces of each cell, counter-clockwise seen from
/// outside.
struct PolyhedronList {
    std::vector<Vec3> points = {};
    /// The faces of all cells, one after the other.
    Faces faces = {};
    /// Cell s has the faces cell_begin[s] ... cell_begin[s + 1] - 1.
    std::vector<int> cell_begin = {0};

    int n_cells() const { return static_cast<int>(cell_begin.size()) - 1; }
};

/// Returns the polyhedra of a mesh as a list.
PolyhedronList polyhedron_list(const PolyhedralMesh& mesh);

/// Joins polyhedra into a mesh: faces on the same points become inner faces, and the others are
/// paired along the seam by their positions. The orbits of points follow from these pairs.
///
/// Example usage:
///   const PolyhedralMesh mesh = assembled_mesh(lattice, polyhedron_list(other));
///   const PolyhedralProof proof = prove_polyhedra(mesh);
///
/// Law, tested by number:
///   (1) assembled_mesh(lattice, polyhedron_list(mesh)) has the points, cells and pairs of `mesh`.
///
/// @param least_tolerance  within which partners agree, as prove_polyhedra() takes it.
/// @throws NotATile if a face belongs to more than two cells, or a boundary face has no partner.
PolyhedralMesh assembled_mesh(const Lattice& lattice, const PolyhedronList& cells,
                              double least_tolerance = 0);

}  // namespace pcvt::space
