#pragma once

#include <string>
#include <vector>

#include "mesher/base/faces.hpp"
#include "mesher/space/mesh/cell_complex.hpp"

namespace pcvt::space {

/// "seam_I_J_K", the word of a side of a seam.
std::string seam_name(Offset offset);

/// One side of a seam: a run of boundary faces of a polyhedral mesh.
struct PolyhedralPatch {
    int first_face;
    int n_faces;
    /// The patch whose face i matches face i of this patch.
    int partner;
    /// (I, J, K): the partner's faces are the faces of this patch plus the translation.
    Offset offset;
};

/// A tile of whole polyhedra, with faces in the order that finite-volume solvers require. Cell s is
/// the cell of site s.
///
/// Laws, which prove_polyhedra() proves by number:
///   (1) Inner faces come first, with owner < neighbour, sorted by (owner, neighbour); they are
///       counter-clockwise seen from the neighbour. Boundary faces follow, patch by patch, and are
///       counter-clockwise seen from outside.
///   (2) Each cell is a convex polyhedron with positive volume, whose faces close.
///   (3) Each boundary face has one partner, by one translation; patches say which, and the faces
///       of a pair match point by point if one is traversed forwards and the other backwards from
///       its first point.
///   (4) Glued along the seam, vertices - edges + faces - cells = 0, and the volumes sum to that of
///       the domain.
///   (5) The cells are connected across inner faces.
///   (6) Each point is that of its orbit with the smallest number plus a translation.
struct PolyhedralMesh {
    Lattice lattice;
    /// Positions, length units.
    std::vector<Vec3> points = {};
    /// For each point, the smallest number on its orbit, and the offset from that point.
    std::vector<int> point_orbit = {};
    std::vector<Offset> point_offset = {};
    /// On these points.
    Faces faces = {};
    /// The cell behind each face, and the cell in front of each inner face.
    std::vector<int> owner = {};
    std::vector<int> neighbour = {};
    /// The two sides of a translation follow each other, (I, J, K) > 0 first.
    std::vector<PolyhedralPatch> patches = {};
    /// The number of cells.
    int n_cells = 0;
    /// As CellComplex::short_edges: the cells are convex within this part of h.
    double short_edges = 0;

    int n_points() const { return static_cast<int>(points.size()); }
    int n_faces() const { return static_cast<int>(owner.size()); }
    int n_inner_faces() const { return static_cast<int>(neighbour.size()); }
};

/// Lays the cells of a Voronoi diagram out as one tile round the domain at the origin.
///
/// Example usage:
///   const PolyhedralMesh mesh = polyhedral_mesh(sites, cell_complex(sites, tetrahedra));
///   const PolyhedralProof proof = prove_polyhedra(mesh);
PolyhedralMesh polyhedral_mesh(const Sites& sites, const CellComplex& complex);

}  // namespace pcvt::space
