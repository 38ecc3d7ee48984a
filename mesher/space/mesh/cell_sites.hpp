#pragma once

#include "mesher/space/mesh/polyhedral_mesh.hpp"

namespace pcvt::space {

/// Returns the image of each site that lies in its cell of the tile: 3 x n, length units.
///
/// Example usage:
///     const Points images = sites_in_cells(sites, mesh);
///     const CellSiteFigures figures = prove_cell_sites(mesh, images);
Points sites_in_cells(const Sites& sites, const PolyhedralMesh& mesh);

/// The largest distance of a corner of a face from the plane halfway between its sites, in units of
/// h. Corners within 1e-9 h of each other are one point, which may lie that far from each of the
/// planes that meet there; the rest is room for rounding.
inline constexpr double kBisectorTolerance = 1e-8;

/// Distances in units of h, the cube root of volume / n.
struct CellSiteFigures {
    /// The largest distance of a corner of a face from the plane halfway between the sites of the
    /// two cells that share the face.
    double from_bisector = 0;
    /// The largest distance of a site from the centroid of its cell.
    double from_centroid = 0;
};

/// Proves that the cells are the periodic Voronoi cells of the sites: each face lies in the plane
/// halfway between the sites of its two cells, each of which lies on the side of its site. Cells
/// that fill the torus and satisfy this at each face are the Voronoi cells.
///
/// @pre prove_polyhedra() has proved the mesh.
/// @param sites  3 x n, the image of each site that lies in its cell, length units.
/// @throws NotATile naming the first cell that is not that of its site.
CellSiteFigures prove_cell_sites(const PolyhedralMesh& mesh, const Points& sites);

}  // namespace pcvt::space
