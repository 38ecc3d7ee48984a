#include "mesher/plane/mesh/voronoi.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "mesher/base/checkpoint.hpp"
#include "mesher/base/error.hpp"
#include "mesher/cells/empty_cells.hpp"
#include "mesher/plane/geometry/polygon.hpp"
#include "mesher/plane/mesh/valence.hpp"
#include "mesher/torus/offset_disjoint_sets.hpp"

namespace pcvt::plane {
namespace {

/// In units of h: crossings of sides by less than this are rounding errors.
constexpr double kCrossing = 1e-3 * kSameVertex;

/// Voronoi vertices before and after merging.
struct DualVertices {
    std::vector<Vec2> position;  ///< of each triangle's dual vertex, in the triangle's frame
    OffsetDisjointSets<Offset> merged;
};

std::vector<Vec2> dual_positions(const PeriodicDelaunay& delaunay) {
    std::vector<Vec2> positions;
    positions.reserve(static_cast<std::size_t>(delaunay.triangulation().n_triangles()));
    for (int k = 0; k < delaunay.triangulation().n_triangles(); ++k) {
        checkpoint_each(k);
        positions.push_back(delaunay.dual_vertex(k));
    }
    return positions;
}

/// The dual edge of h as a vector.
/// @param position  returns the position of a triangle's circumcentre, in the triangle's frame.
template <class Position>
Vec2 dual_edge(const PeriodicDelaunay& delaunay, const Position& position, int h) {
    const TorusTriangulation& t = delaunay.triangulation();
    const Lattice& reduced = delaunay.sites().reduction().reduced;
    const Vec2 across = position(t.opposite(h) / 3) + reduced.translation(t.frame_across(h));
    return across - position(h / 3);
}

/// A dual edge is half as long as its edge times the sum of the cotangents of both opposite angles.
/// Where these angles are above 0.01 and the edge is shorter than 1000 h, rounding changes this
/// product by less than 1e-9 h.
constexpr double kLeastSine = 0.01;
constexpr double kLongestEdge = 1000;
constexpr double kRoundingOfDualEdge = 1e-9;

/// Whether the dual edge of h is certainly longer than `shortest`, without circumcentres.
bool is_certainly_longer(const PeriodicDelaunay& delaunay, int h, double shortest) {
    if (delaunay.weights().size() > 0) return false;
    const TorusTriangulation& t = delaunay.triangulation();
    const Sites& sites = delaunay.sites();
    const auto at = [&](const Corner& corner) { return image(sites, corner.site, corner.offset); };
    const Image p = at(t.corner(h));
    const Image q = at(t.corner(TorusTriangulation::next(h)));
    double cotangents = 0;
    for (const Corner& apex : {t.corner(TorusTriangulation::previous(h)), t.apex_across(h)}) {
        const Lattice& reduced = sites.reduction().reduced;
        const Vec2 d = reduced.to_position(difference(at(apex), p));
        const Vec2 e = reduced.to_position(difference(at(apex), q));
        const double cross = std::abs(detail::cross(d, e));
        if (!(cross * cross > kLeastSine * kLeastSine * d.squaredNorm() * e.squaredNorm())) {
            return false;
        }
        cotangents += d.dot(e) / cross;
    }
    const double length = sites.reduction().reduced.to_position(difference(p, q)).norm();
    const double spacing = sites.spacing();
    return length < kLongestEdge * spacing &&
           length / 2 * cotangents > shortest + kRoundingOfDualEdge * spacing;
}

/// Merges the ends of each dual edge that is short between the positions of merged vertices.
/// @returns whether there was one.
bool merge_shortened_edges(const PeriodicDelaunay& delaunay, double shortest, DualVertices& dual) {
    const TorusTriangulation& t = delaunay.triangulation();
    const Lattice& reduced = delaunay.sites().reduction().reduced;
    bool merges = false;
    for (int h = 0; h < t.n_halfedges(); ++h) {
        checkpoint_each(h);
        const int o = t.opposite(h);
        const Offset frame = t.frame_across(h);
        const auto from = dual.merged.root(h / 3);
        const auto to = dual.merged.root(o / 3);
        if (o < h || from.orbit == to.orbit) continue;
        const Offset between = to.offset + frame - from.offset;
        const Vec2 end = dual.position[to.orbit] + reduced.translation(between);
        if (!((end - dual.position[from.orbit]).norm() < shortest)) continue;
        dual.merged.join(h / 3, o / 3, frame);
        merges = true;
    }
    return merges;
}

DualVertices dual_vertices(const PeriodicDelaunay& delaunay) {
    const TorusTriangulation& t = delaunay.triangulation();
    DualVertices dual{dual_positions(delaunay), OffsetDisjointSets<Offset>(t.n_triangles())};
    const double shortest = kSameVertex * delaunay.sites().spacing();
    bool merges = false;
    const auto position = [&](int triangle) { return dual.position[triangle]; };
    for (int h = 0; h < t.n_halfedges(); ++h) {
        checkpoint_each(h);
        const int o = t.opposite(h);
        if (o < h || !(dual_edge(delaunay, position, h).norm() < shortest)) continue;
        merges = dual.merged.join(h / 3, o / 3, t.frame_across(h)) || merges;
    }
    // A merged vertex has the position of one of its circumcentres, which may shorten other edges.
    while (merges) merges = merge_shortened_edges(delaunay, shortest, dual);
    return dual;
}

/// Returns the corners of the cell of the site that h leaves, around the image of the site at
/// offset (0, 0).
std::vector<MeshCorner> cell_corners(const TorusTriangulation& t,
                                     OffsetDisjointSets<Offset>& merged, int h) {
    std::vector<MeshCorner> corners;
    const int first = h;
    do {
        const auto root = merged.root(h / 3);
        const MeshCorner corner{root.orbit, root.offset - t.corner(h).offset};
        if (corners.empty() || corners.back() != corner) corners.push_back(corner);
        h = t.opposite(TorusTriangulation::previous(h));
    } while (h != first);
    while (corners.size() > 1 && corners.front() == corners.back()) corners.pop_back();
    return corners;
}

void require_polygon(const std::vector<MeshCorner>& corners, SiteId site) {
    std::vector<MeshCorner> sorted = corners;
    std::sort(sorted.begin(), sorted.end());
    const bool distinct = std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end();
    if (corners.size() < 3 || !distinct) {
        throw TinyCell(site, "its neighbours are too close; remove or move one of them");
    }
}

/// Merged vertices take the position of one of them, which may tear a cell as small as their
/// spread.
void require_simple_cells(const PeriodicMesh& mesh) {
    const double h = std::sqrt(mesh.lattice.area() / mesh.n_faces());
    Polygon polygon;
    for (int f = 0; f < mesh.n_faces(); ++f) {
        checkpoint_each(f);
        face_polygon(mesh, f, polygon);
        if (!(polygon_area(polygon) > 0) || crosses_itself(polygon, kCrossing * h)) {
            throw InvalidInput(
                "the corners of the cell of site " + std::to_string(f) +
                " are too close to be distinguished: too many sites lie on one circle; "
                "move some of them");
        }
    }
}

/// Moves each representative into the fundamental domain of the reduced basis.
void wrap_vertices(PeriodicMesh& mesh, const Lattice& reduced) {
    std::vector<Offset> moved(mesh.vertices.size());
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
        checkpoint_each(v);
        const Vec2 u = reduced.to_lattice(mesh.vertices[v]);
        moved[v] = {wrap(u.x()).whole, wrap(u.y()).whole};
        mesh.vertices[v] -= reduced.translation(moved[v]);
    }
    for (std::size_t c = 0; c < mesh.corner_vertex.size(); ++c) {
        checkpoint_each(c);
        mesh.corner_offset[c] = mesh.corner_offset[c] + moved[mesh.corner_vertex[c]];
    }
}

/// Converts offsets to the user's basis and links the faces.
void finish(PeriodicMesh& mesh, const Reduction& reduction) {
    for (Offset& offset : mesh.corner_offset) offset = reduction.to_original(offset);
    link_faces(mesh);
}

std::vector<int> outgoing_halfedges(const TorusTriangulation& t) {
    std::vector<int> outgoing(static_cast<std::size_t>(t.n_sites()), -1);
    for (int h = t.n_halfedges(); h-- > 0;) outgoing[t.corner(h).site] = h;
    return outgoing;
}

}  // namespace

PeriodicMesh cell_mesh(const PeriodicDelaunay& delaunay) {
    const TorusTriangulation& t = delaunay.triangulation();
    DualVertices dual = dual_vertices(delaunay);
    PeriodicMesh mesh{.lattice = delaunay.sites().lattice(), .kind = MeshKind::kVoronoi};
    // Number the merged vertices.
    std::vector<int> vertex_of(dual.position.size(), -1);
    for (int k = 0; k < t.n_triangles(); ++k) {
        checkpoint_each(k);
        if (dual.merged.root(k).orbit != k) continue;
        vertex_of[k] = mesh.n_vertices();
        mesh.vertices.push_back(dual.position[k]);
    }
    // Collect the corners of the cell of each site.
    const auto outgoing = outgoing_halfedges(t);
    for (SiteId s = 0; s < t.n_sites(); ++s) {
        checkpoint_each(s);
        const auto corners = cell_corners(t, dual.merged, outgoing[s]);
        require_polygon(corners, s);
        for (const MeshCorner& corner : corners) {
            mesh.corner_vertex.push_back(vertex_of[corner.vertex]);
            mesh.corner_offset.push_back(corner.offset);
        }
        mesh.face_begin.push_back(static_cast<int>(mesh.corner_vertex.size()));
        mesh.site.push_back(s);
        mesh.site_points.push_back(delaunay.sites().position(s));
    }
    // Wrap the vertices, link the faces and check the cells.
    wrap_vertices(mesh, delaunay.sites().reduction().reduced);
    finish(mesh, delaunay.sites().reduction());
    require_simple_cells(mesh);
    return mesh;
}

std::vector<int> cell_sides(const PeriodicDelaunay& delaunay) {
    const TorusTriangulation& t = delaunay.triangulation();
    const double shortest = kShortEdge * delaunay.sites().spacing();
    std::vector<int> sides(static_cast<std::size_t>(t.n_sites()));
    const auto position = [&](int triangle) { return delaunay.dual_vertex(triangle); };
    for (int h = 0; h < t.n_halfedges(); ++h) {
        checkpoint_each(h);
        if (t.opposite(h) < h) continue;
        if (!is_certainly_longer(delaunay, h, shortest) &&
            !(dual_edge(delaunay, position, h).norm() > shortest)) {
            continue;
        }
        ++sides[t.corner(h).site];
        ++sides[t.corner(TorusTriangulation::next(h)).site];
    }
    return sides;
}

PeriodicMesh triangle_mesh(const PeriodicDelaunay& delaunay) {
    const TorusTriangulation& t = delaunay.triangulation();
    PeriodicMesh mesh{.lattice = delaunay.sites().lattice(), .kind = MeshKind::kDelaunay};
    for (SiteId s = 0; s < t.n_sites(); ++s) {
        checkpoint_each(s);
        mesh.vertices.push_back(delaunay.sites().position(s));
        mesh.site.push_back(s);
    }
    for (int h = 0; h < t.n_halfedges(); ++h) {
        checkpoint_each(h);
        mesh.corner_vertex.push_back(t.corner(h).site);
        mesh.corner_offset.push_back(t.corner(h).offset);
        if (h % 3 == 2) mesh.face_begin.push_back(h + 1);
    }
    finish(mesh, delaunay.sites().reduction());
    return mesh;
}

PeriodicMesh periodic_mesh(const PeriodicDelaunay& delaunay, MeshKind kind) {
    return kind == MeshKind::kVoronoi ? cell_mesh(delaunay) : triangle_mesh(delaunay);
}

}  // namespace pcvt::plane
