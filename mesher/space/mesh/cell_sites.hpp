#pragma once

#include "mesher/base/checkpoint.hpp"
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

/// Returns the image of the site of each cell of a tile whose cells are these images of those of a
/// complex (chosen_images()): 3 x n, length units. A power cell may not contain its site.
Points sites_of_cells(const CellComplex& complex, const std::vector<Offset>& images);

/// Returns the cell of each piece of a box (PolyhedralMesh::piece_cell) from the sites of the
/// pieces: consecutive sites are those of one cell if they differ by a translation of the lattice.
/// Empty for whole cells, whose sites are all different.
/// @param sites  one a piece, length units.
std::vector<SiteId> cells_of_pieces(const Lattice& lattice, const Points& sites);

/// Whether a face that has pieces with these images of sites on its two sides is one in which a box
/// cuts their cell, and no face of the cell.
bool is_cut(const PolyhedralMesh& mesh, int cell, int across, const Vec3& site, const Vec3& other);

/// The plane of equal power distance of two sites.
struct SitePlane {
    Vec3 point;
    /// Of length 1, towards the second site.
    Vec3 direction;
    /// Of the two sites, length units.
    double distance;

    /// The distance of p from the plane, above 0 on the side of the second site.
    double height(const Vec3& p) const { return (p - point).dot(direction); }
};

/// Returns the plane between the site of a cell and an image of that of another.
/// @param other    the image of site `across`.
/// @param weights  one a site, or empty.
SitePlane plane_between(int cell, int across, const Vec3& other, const Points& sites,
                        const Eigen::VectorXd& weights);

/// Calls visit(face, across, other) for each inner face and each side of the seam, but for those in
/// which a box cuts a cell: `across` is the cell on the other side of the face, and `other` the
/// image of its site there.
///
/// Example usage:
///     for_each_side(mesh, sites, [&](int face, int across, const Vec3& other) {
///         const SitePlane plane = plane_between(mesh.owner[face], across, other, sites, weights);
///     });
template <class Visit>
void for_each_side(const PolyhedralMesh& mesh, const Points& sites, const Visit& visit) {
    const auto visit_unless_cut = [&](int face, int across, const Vec3& other) {
        const int cell = mesh.owner[face];
        if (!is_cut(mesh, cell, across, sites.col(cell), other)) visit(face, across, other);
    };
    for (int f = 0; f < mesh.n_inner_faces(); ++f) {
        checkpoint_each(f);
        visit_unless_cut(f, mesh.neighbour[f], Vec3(sites.col(mesh.neighbour[f])));
    }
    for (const FiniteVolumePatch& patch : mesh.patches) {
        // The neighbour across the seam is the partner's owner, back by the translation.
        const int partner = mesh.patches[patch.partner].first_face;
        for (int k = 0; k < patch.n_faces; ++k) {
            checkpoint_each(k);
            const int across = mesh.owner[partner + k];
            visit_unless_cut(patch.first_face + k, across,
                             Vec3(sites.col(across) - patch.separation));
        }
    }
}

/// Proves that the cells are the periodic Voronoi cells of the sites: each face lies in the plane
/// halfway between the sites of its two cells, each of which lies on the side of its site. Cells
/// that fill the torus and satisfy this at each face are the Voronoi cells. With weights the cells
/// are power cells, and the plane that of equal power distances. Distances, and the figures, are
/// those in the metric of the mesh.
///
/// Faces in which a box cuts a cell are no part of the boundary of the cell, whose pieces all have
/// the image of its site in their frame.
///
/// @pre prove_polyhedra() has proved the mesh.
/// @param sites    3 x n, the image of each site that its cell belongs to, length units.
/// @param weights  length^2, one a site; empty for Voronoi cells.
/// @throws NotATile naming the first cell that is not that of its site.
CellSiteFigures prove_cell_sites(const PolyhedralMesh& mesh, const Points& sites,
                                 const Eigen::VectorXd& weights = {});

}  // namespace pcvt::space
