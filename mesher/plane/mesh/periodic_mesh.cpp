#include "mesher/plane/mesh/periodic_mesh.hpp"

#include "mesher/base/checkpoint.hpp"
#include "mesher/plane/geometry/edge_matching.hpp"

namespace pcvt::plane {
namespace {

int floor_divide(int x, int divisor) { return (x - ((x % divisor) + divisor) % divisor) / divisor; }

/// A copy of the small domain: its index within the large domain, and the offset of the latter.
struct Copy {
    int index;      ///< row by row
    Offset offset;  ///< in the large lattice
};

Copy copy_at(Offset o, int columns, int rows) {
    const Offset domain{floor_divide(o.i, columns), floor_divide(o.j, rows)};
    const int column = o.i - domain.i * columns;
    const int row = o.j - domain.j * rows;
    return {row * columns + column, domain};
}

void append_copy(const PeriodicMesh& mesh, Offset here, int columns, int rows,
                 PeriodicMesh& cover) {
    const Vec2 translation = mesh.lattice.translation(here);
    const int first_corner = cover.n_corners();
    const int first_face = cover.n_faces();
    for (const Vec2& p : mesh.site_points) cover.site_points.push_back(p + translation);
    for (const Vec2& v : mesh.vertices) cover.vertices.push_back(v + translation);
    cover.site.insert(cover.site.end(), mesh.site.begin(), mesh.site.end());
    cover.whole_sides.insert(cover.whole_sides.end(), mesh.whole_sides.begin(),
                             mesh.whole_sides.end());
    for (int f = 0; f < mesh.n_faces(); ++f) {
        checkpoint_each(f);
        cover.face_begin.push_back(first_corner + mesh.face_begin[f + 1]);
    }
    for (int c = 0; c < mesh.n_corners(); ++c) {
        checkpoint_each(c);
        const Copy vertex = copy_at(here + mesh.corner_offset[c], columns, rows);
        const Copy across = copy_at(here + mesh.frame_across(c), columns, rows);
        cover.corner_vertex.push_back(vertex.index * mesh.n_vertices() + mesh.corner_vertex[c]);
        cover.corner_offset.push_back(vertex.offset);
        cover.corner_face.push_back(first_face + mesh.corner_face[c]);
        cover.opposite.push_back(across.index * mesh.n_corners() + mesh.opposite[c]);
    }
}

}  // namespace

void link_faces(PeriodicMesh& mesh) {
    mesh.corner_face.clear();
    for (int f = 0; f < mesh.n_faces(); ++f) {
        checkpoint_each(f);
        mesh.corner_face.resize(static_cast<std::size_t>(mesh.face_begin[f + 1]), f);
    }
    std::vector<DirectedEdge> halfedges;
    halfedges.reserve(mesh.corner_vertex.size());
    for (int c = 0; c < mesh.n_corners(); ++c) {
        checkpoint_each(c);
        const int next = mesh.next(c);
        halfedges.push_back({mesh.corner_vertex[c], mesh.corner_vertex[next],
                             mesh.corner_offset[next] - mesh.corner_offset[c]});
    }
    mesh.opposite = match_edges(halfedges);
}

void face_polygon(const PeriodicMesh& mesh, int f, Polygon& polygon) {
    polygon.clear();
    for (int c = mesh.face_begin[f]; c < mesh.face_begin[f + 1]; ++c) {
        polygon.push_back(mesh.point(c));
    }
}

Polygon face_polygon(const PeriodicMesh& mesh, int f) {
    Polygon polygon;
    face_polygon(mesh, f, polygon);
    return polygon;
}

std::vector<bool> interface_vertices(const PeriodicMesh& mesh, std::span<const int> tags) {
    std::vector<int> first(mesh.vertices.size(), -1);
    std::vector<bool> found(mesh.vertices.size());
    for (int c = 0; c < mesh.n_corners(); ++c) {
        const int v = mesh.corner_vertex[c];
        const int tag = tags[mesh.corner_face[c]];
        if (first[v] < 0) first[v] = tag;
        found[v] = found[v] || tag != first[v];
    }
    return found;
}

PeriodicMesh repeated(PeriodicMesh mesh, int columns, int rows) {
    if (columns == 1 && rows == 1) return mesh;
    PeriodicMesh cover{.lattice = mesh.lattice.repeated(columns, rows), .kind = mesh.kind};
    for (int j = 0; j < rows; ++j) {
        for (int i = 0; i < columns; ++i) append_copy(mesh, {i, j}, columns, rows, cover);
    }
    return cover;
}

}  // namespace pcvt::plane
