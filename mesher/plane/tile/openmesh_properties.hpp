#pragma once

#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <cmath>
#include <limits>

#include "mesher/plane/geometry/sites.hpp"

namespace pcvt::plane {

struct DoubleTraits : OpenMesh::DefaultTraits {
    using Point = OpenMesh::Vec3d;
    using Normal = OpenMesh::Vec3d;
};

/// Cells as polygons, z = 0.
using CellMesh = OpenMesh::PolyMesh_ArrayKernelT<DoubleTraits>;
/// Delaunay triangles, or triangles inside of cells, z = 0.
using TriangleMesh = OpenMesh::TriMesh_ArrayKernelT<DoubleTraits>;

/// The position of a site, length units. A new face has none, also while OpenMesh reads a file.
struct SitePoint {
    double x = std::numeric_limits<double>::quiet_NaN();
    double y = std::numeric_limits<double>::quiet_NaN();

    bool is_known() const { return !std::isnan(x); }
};

/// The pairing of a tile's boundary, as OpenMesh properties that `.om` files keep.
///
/// Names in the file: "pcvt_partner", "pcvt_partner_offset", "pcvt_orbit", "pcvt_orbit_offset",
/// "pcvt_face_site", "pcvt_vertex_site" and, of the mesh, "pcvt_lattice" (ax, ay, bx, by) and
/// "pcvt_sites" (columns, rows, length of short edges, 0, x0, y0, x1, y1, ...), "pcvt_site_weights"
/// "pcvt_metric" (ratio, degrees), "pcvt_walls" (across x, across y: 0 or 1) and "pcvt_holes"
/// (names and edges). Boundary halfedges on walls and at holes have no partner.
struct OpenMeshProperties {
    /// A boundary halfedge's partner, as a halfedge index; -1 for a halfedge that has a face.
    OpenMesh::HPropHandleT<int> partner;
    /// position(to-vertex of the partner) = position(from-vertex) + translation.
    OpenMesh::HPropHandleT<OpenMesh::Vec2i> partner_offset;
    /// The smallest vertex index on the vertex's orbit.
    OpenMesh::VPropHandleT<int> orbit;
    /// position(vertex) = position(orbit) + translation.
    OpenMesh::VPropHandleT<OpenMesh::Vec2i> orbit_offset;
    /// The site of a cell, or of the cell that a grain's triangle lies in; -1 in a mesh of Delaunay
    /// triangles.
    OpenMesh::FPropHandleT<int> face_site;
    /// The position of a cell's site; NaN where it is not known. `.om` does not keep it.
    OpenMesh::FPropHandleT<SitePoint> site_point;
    /// The sides of the whole cell that a piece or a grain's triangle is part of; else 0. `.om`
    /// does not keep it.
    OpenMesh::FPropHandleT<int> whole_sides;
    /// The site at a vertex of a mesh of Delaunay triangles; else -1.
    OpenMesh::VPropHandleT<int> vertex_site;
    OpenMesh::MPropHandleT<std::vector<double>> lattice;
    /// Tile::columns, rows and short_edges, 0, then x and y of each site
    /// (mesher/plane/tile/site_positions.hpp); empty where they are not known.
    OpenMesh::MPropHandleT<std::vector<double>> sites;
    /// Tile::site_weights.
    OpenMesh::MPropHandleT<std::vector<double>> site_weights;
    /// The numbers of Tile::metric; empty for a round one.
    OpenMesh::MPropHandleT<std::vector<double>> metric;
    /// 1 for walls across x, 1 for walls across y; empty without walls.
    OpenMesh::MPropHandleT<std::vector<double>> walls;
    /// holes_as_numbers() (mesher/plane/tile/tile_holes.hpp).
    OpenMesh::MPropHandleT<std::vector<double>> holes;

    /// Adds the properties to a mesh, or finds them where they are there already.
    void attach(CellMesh& mesh);
    void attach(TriangleMesh& mesh);
};

}  // namespace pcvt::plane
