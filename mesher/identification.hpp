#pragma once

#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include "mesher/sites.hpp"

namespace pcvt {

struct DoubleTraits : OpenMesh::DefaultTraits {
    using Point = OpenMesh::Vec3d;
    using Normal = OpenMesh::Vec3d;
};

/// Cells as polygons, z = 0.
using CellMesh = OpenMesh::PolyMesh_ArrayKernelT<DoubleTraits>;
/// Delaunay triangles, z = 0.
using TriangleMesh = OpenMesh::TriMesh_ArrayKernelT<DoubleTraits>;

/// The pairing of a tile's boundary, as OpenMesh properties that `.om` files keep.
///
/// Names in the file: "pcvt_partner", "pcvt_partner_offset", "pcvt_orbit", "pcvt_orbit_offset",
/// "pcvt_face_site", "pcvt_vertex_site" and, of the mesh, "pcvt_lattice" (ax, ay, bx, by).
struct Identification {
    /// A boundary halfedge's partner, as a halfedge index; -1 for a halfedge that has a face.
    OpenMesh::HPropHandleT<int> partner;
    /// position(to-vertex of the partner) = position(from-vertex) + translation.
    OpenMesh::HPropHandleT<OpenMesh::Vec2i> partner_offset;
    /// The smallest vertex index on the vertex's orbit.
    OpenMesh::VPropHandleT<int> orbit;
    /// position(vertex) = position(orbit) + translation.
    OpenMesh::VPropHandleT<OpenMesh::Vec2i> orbit_offset;
    /// The site of a cell; -1 in a triangle mesh.
    OpenMesh::FPropHandleT<int> face_site;
    /// Where that site stands; zero in a triangle mesh. The only property that `.om` does not keep.
    OpenMesh::FPropHandleT<OpenMesh::Vec3d> site_point;
    /// The site at a vertex of a triangle mesh; -1 in a cell mesh.
    OpenMesh::VPropHandleT<int> vertex_site;
    OpenMesh::MPropHandleT<std::vector<double>> lattice;

    /// Adds the properties to a mesh, or finds them where they are there already.
    void attach(CellMesh& mesh);
    void attach(TriangleMesh& mesh);
};

}  // namespace pcvt
