#pragma once

#include <vector>

#include "mesher/lattice/sites.hpp"
#include "mesher/mesh/mesh_kind.hpp"

namespace pcvt {

/// A mesh of the whole torus by orbits: each face and each vertex stands once, for all its images.
///
/// A halfedge is the index of the corner that it leaves. Corner c of face f lies at
/// vertices[corner_vertex[c]] + translation(corner_offset[c]) when f stands in its own frame.
struct PeriodicMesh {
    Lattice lattice;
    MeshKind kind;
    /// Positions of the representatives, length units.
    std::vector<Vec2> vertices;
    /// n_faces + 1 entries; the corners of a face run counter-clockwise.
    std::vector<int> face_begin;
    std::vector<int> corner_vertex;
    std::vector<Offset> corner_offset;
    std::vector<int> corner_face;
    /// The halfedge across; an involution without fixed points.
    std::vector<int> opposite;
    /// Cells and grains: the site of each face. Delaunay triangles: the site of each vertex.
    std::vector<SiteId> site;
    /// Cells: where the site of each face stands in the frame of the face. Else: empty.
    std::vector<Vec2> site_points = {};

    /// Pieces of cells and grains: the number of sides of the whole cell that a face is part of.
    /// Whole cells: that before short edges were removed, or empty. Delaunay triangles: empty.
    std::vector<int> whole_sides = {};

    int n_faces() const { return static_cast<int>(face_begin.size()) - 1; }
    int n_vertices() const { return static_cast<int>(vertices.size()); }
    int n_corners() const { return static_cast<int>(corner_vertex.size()); }
    /// The corner after c on its face.
    int next(int c) const {
        const int f = corner_face[c];
        return c + 1 == face_begin[f + 1] ? face_begin[f] : c + 1;
    }
    /// Where corner c stands in the frame of its face.
    Vec2 point(int c) const {
        return vertices[corner_vertex[c]] + lattice.translation(corner_offset[c]);
    }
    /// What to add to an offset in the frame of the face across c to get it in that of c's face.
    Offset frame_across(int c) const { return corner_offset[c] - corner_offset[next(opposite[c])]; }
};

/// Fills `corner_face` and `opposite` from the corners of the faces.
/// @throws InternalError unless every edge on the torus has exactly two sides.
void link_faces(PeriodicMesh& mesh);

/// The cover of `mesh` by columns x rows of its domains: a periodic mesh of
/// mesh.lattice.repeated(). Face f of copy (i, j) is face (j columns + i) n_faces + f, and keeps
/// its site's id.
PeriodicMesh repeated(const PeriodicMesh& mesh, int columns, int rows);

}  // namespace pcvt
