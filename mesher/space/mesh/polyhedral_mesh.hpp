#pragma once

#include <vector>

#include "mesher/cells/finite_volume_mesh.hpp"
#include "mesher/space/geometry/metric.hpp"
#include "mesher/space/mesh/cell_complex.hpp"

namespace pcvt::space {

/// A tile of whole polyhedra, or a box of pieces of them, with faces in the order that
/// finite-volume solvers require. Cell s is the cell of site s, or a piece of that of site
/// piece_cell[s].
///
/// Laws, which prove_polyhedra() proves by number:
///   (1) Inner faces come first, with owner < neighbour, sorted by (owner, neighbour); they are
///       counter-clockwise seen from the neighbour. Boundary faces follow, patch by patch, and are
///       counter-clockwise seen from outside.
///   (2) Each cell is a convex polyhedron with positive volume, whose faces close.
///   (3) Each boundary face has one partner, by one translation; patches say which, all are cyclic,
///       and the two sides of a translation follow each other, (I, J, K) > 0 first. The faces of a
///       pair match point by point if one is traversed forwards and the other backwards from its
///       first point.
///   (4) Glued along the seam, vertices - edges + faces - cells = 0, and the volumes sum to that of
///       the domain.
///   (5) The cells are connected across inner faces.
///   (6) Each point is that of its orbit with the smallest number plus a translation.
struct PolyhedralMesh : FiniteVolumeMesh {
    Lattice lattice;
    /// For each point, the smallest number on its orbit, and the offset from that point.
    std::vector<int> point_orbit = {};
    std::vector<Offset> point_offset = {};
    /// As CellComplex::piece_cell: the tile is a box of pieces of cells, unless it is empty.
    std::vector<SiteId> piece_cell = {};
    /// As CellComplex::short_edges: the cells are convex within this part of h.
    double short_edges = 0;
    /// Elongated cells: the metric in which they are the cells of their sites.
    Metric metric = {};

    SiteId site_of(int cell) const { return piece_cell.empty() ? cell : piece_cell[cell]; }
    int n_sites() const { return piece_cell.empty() ? n_cells : piece_cell.back() + 1; }
};

/// Adds the two patches of a seam, whose faces the next 2 n faces of the mesh are.
void add_seam_patches(const Offset& offset, int n, PolyhedralMesh& mesh);

/// Lays the cells of a Voronoi diagram out as one tile round the domain.
///
/// Example usage:
///   const PolyhedralMesh mesh = polyhedral_mesh(sites, cell_complex(sites, tetrahedra));
///   const PolyhedralProof proof = prove_polyhedra(mesh);
///
/// @param origin  the corner of the domain, length units.
/// @param images  gets the image of each cell that the tile has, as chosen_images() returns them,
///                unless it is null.
PolyhedralMesh polyhedral_mesh(const Sites& sites, const CellComplex& complex,
                               const Vec3& origin = Vec3::Zero(),
                               std::vector<Offset>* images = nullptr);

}  // namespace pcvt::space
