#pragma once

#include <span>
#include <vector>

#include "mesher/plane/geometry/polygon.hpp"
#include "mesher/plane/geometry/sites.hpp"
#include "mesher/plane/mesh/mesh_kind.hpp"

namespace pcvt::plane {

/// A corner of a face, in the frame of the face: an image of a vertex.
struct MeshCorner {
    int vertex;
    Offset offset;
    friend auto operator<=>(const MeshCorner&, const MeshCorner&) = default;
};

/// A mesh of the whole torus that stores one face and one vertex per orbit.
///
/// Example usage:
///   for (int c = mesh.face_begin[f]; c < mesh.face_begin[f + 1]; ++c) {
///       const Vec2 side = mesh.point(mesh.next(c)) - mesh.point(c);
///       const int neighbour = mesh.corner_face[mesh.opposite[c]];
///   }
///
/// A halfedge has the index of the corner that it leaves. In the frame of its face, corner c lies
/// at vertices[corner_vertex[c]] + translation(corner_offset[c]).
struct PeriodicMesh {
    Lattice lattice;
    MeshKind kind;
    /// The positions of the representatives, length units.
    std::vector<Vec2> vertices = {};
    /// n_faces + 1 entries; the corners of a face are in counter-clockwise order.
    std::vector<int> face_begin = {0};
    std::vector<int> corner_vertex = {};
    std::vector<Offset> corner_offset = {};
    std::vector<int> corner_face = {};
    /// The halfedge on the other side of the edge; an involution without fixed points. In a mesh
    /// between walls (walled_mesh.hpp) -1 on walls; other functions take meshes of the torus.
    std::vector<int> opposite = {};
    /// The site of each face for cells and grains; the site of each vertex for Delaunay triangles.
    std::vector<SiteId> site = {};
    /// The position of the site of each face in the frame of the face, for cells; empty for others.
    std::vector<Vec2> site_points = {};

    /// The number of sides of the whole cell that a face is part of, for pieces of cells and for
    /// grains. For whole cells: the number before short edges were removed, or empty. For Delaunay
    /// triangles: empty.
    std::vector<int> whole_sides = {};

    int n_faces() const { return static_cast<int>(face_begin.size()) - 1; }
    int n_vertices() const { return static_cast<int>(vertices.size()); }
    int n_corners() const { return static_cast<int>(corner_vertex.size()); }
    /// Returns the corner after c on its face.
    int next(int c) const {
        const int f = corner_face[c];
        return c + 1 == face_begin[f + 1] ? face_begin[f] : c + 1;
    }
    /// Returns the corner before c on its face.
    int previous(int c) const {
        const int f = corner_face[c];
        return c == face_begin[f] ? face_begin[f + 1] - 1 : c - 1;
    }
    /// Returns the position of corner c in the frame of its face.
    Vec2 point(int c) const {
        return vertices[corner_vertex[c]] + lattice.translation(corner_offset[c]);
    }
    /// Returns the offset to add when an offset is converted from the frame of the face across c to
    /// the frame of the face of c.
    Offset frame_across(int c) const { return corner_offset[c] - corner_offset[next(opposite[c])]; }
};

/// Fills `corner_face` and `opposite` from the corners of the faces.
/// @throws InternalError unless every edge on the torus has exactly two sides.
void link_faces(PeriodicMesh& mesh);

/// Returns the corners of face f in its frame.
Polygon face_polygon(const PeriodicMesh& mesh, int f);
/// Fills `polygon` with them, in the memory that it has.
void face_polygon(const PeriodicMesh& mesh, int f, Polygon& polygon);

/// Returns for each vertex of a mesh whether faces of different tags meet there.
/// @param tags  one for each face.
std::vector<bool> interface_vertices(const PeriodicMesh& mesh, std::span<const int> tags);

/// Returns the mesh of columns x rows copies of the domain, periodic in mesh.lattice.repeated().
/// Face f of copy (i, j) becomes face (j columns + i) n_faces + f and keeps the id of its site.
PeriodicMesh repeated(PeriodicMesh mesh, int columns, int rows);

}  // namespace pcvt::plane
