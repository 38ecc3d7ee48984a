#pragma once

#include <array>
#include <vector>

#include "mesher/space/delaunay/periodic_delaunay.hpp"

namespace pcvt::space {

/// The corners of the side of a tetrahedron opposite to each of its corners, counter-clockwise seen
/// from outside.
inline constexpr std::array<std::array<int, 3>, 4> kOutwardSides{
    {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};

/// A tile of the Delaunay tetrahedra of the 3-torus, or of tetrahedra inside of cells: one image of
/// each tetrahedron, on images of the sites, or of nodes in their place.
///
/// Laws, which prove_tetrahedra() proves by number:
///   (1) Each tetrahedron is positively oriented, and its volume is above kFlatTetrahedron
///       times the smaller of V / n and the cube over its longest edge.
///   (2) Points have the sites 0 ... n - 1, each at least once. Each point is the first point of
///       its site plus the translation by its offset.
///   (3) Each triangle has two tetrahedra, which traverse it in opposite orders: both at its three
///       points, or one of them at these points plus a translation.
///   (4) Glued along the seam, vertices - edges + triangles - tetrahedra = 0, and the volumes sum
///       to that of the domain.
///   (5) The tetrahedra are connected across triangles of the tile.
struct TetrahedralMesh {
    Lattice lattice;
    /// Positions, length units.
    std::vector<Vec3> points = {};
    /// The site of each point, and the offset (I, J, K) from the first point of that site.
    std::vector<SiteId> point_site = {};
    std::vector<Offset> point_offset = {};
    /// Points of each tetrahedron; the fourth lies on the side from which the others turn
    /// counter-clockwise.
    std::vector<std::array<int, 4>> tetrahedra = {};
    /// The site of the cell of each tetrahedron, for tetrahedra inside of cells
    /// (mesher/space/grains): point_site then numbers the nodes of the torus, each with all its
    /// images, and sites are not points. Empty for Delaunay tetrahedra.
    std::vector<SiteId> cell = {};
    /// 2: files also hold the nodes in the middle of edges (midside_nodes.hpp).
    int order = 1;

    /// The image of a site that a point is: equal up to one translation of all images.
    Corner corner(int point) const { return {point_site[point], point_offset[point]}; }
    int n_points() const { return static_cast<int>(points.size()); }
    int n_tetrahedra() const { return static_cast<int>(tetrahedra.size()); }
};

/// Lays the tetrahedra of a Delaunay triangulation out as one connected tile round the domain. The
/// tile grows from the tetrahedron whose barycentre lies next to the centre of the
/// domain, across triangles, always by the image whose barycentre is nearest to that centre; the
/// distance is the largest difference of the coordinates in the reduced basis. Then tied_frames()
/// moves the few tetrahedra that leave points without a partner on a slave of the seam.
///
/// Example usage:
///   const TetrahedralMesh mesh = tetrahedral_mesh(periodic_delaunay(Sites(lattice, points)));
///   const TetrahedralProof proof = prove_tetrahedra(mesh);
///
/// Cost: t log t for t tetrahedra, and that of tied_frames().
///
/// @param origin  the corner of the domain, length units.
TetrahedralMesh tetrahedral_mesh(const PeriodicDelaunay& delaunay,
                                 const Vec3& origin = Vec3::Zero());

}  // namespace pcvt::space
