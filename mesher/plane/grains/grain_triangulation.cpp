#include "mesher/plane/grains/grain_triangulation.hpp"

#include <algorithm>
#include <cmath>

#include "mesher/base/checkpoint.hpp"
#include "mesher/base/error.hpp"
#include "mesher/plane/geometry/polygon.hpp"
#include "mesher/plane/grains/triangle_shape.hpp"
#include "mesher/plane/mesh/valence.hpp"

namespace pcvt::plane {
namespace {

/// An edge is flipped only if the sine of the sum of its opposite angles is below -kClearFlip, so
/// that rounding cannot flip it back and forth.
constexpr double kClearFlip = 1e-12;

/// A corner lies on a line if the sine of the angle between its direction and the line is below
/// this.
constexpr double kOnLine = 1e-10;

/// The rest of a polygon while ears are cut off. Entry i is the edge from its corner to the next.
struct EarEntry {
    int corner;  ///< of the cells
    Vec2 point;
    int halfedge;  ///< of the triangle cut off there, or -1 along the polygon's own edge
};

/// Whether r lies to the left of the line p q or, up to rounding, on it.
bool is_left(const Vec2& p, const Vec2& q, const Vec2& r) {
    return cross(q - p, r - p) >= -kOnLine * (q - p).norm() * (r - p).norm();
}

/// Returns the smallest sine of an angle of the ear at i; -1 if the corner is not an ear.
double ear_quality(const std::vector<EarEntry>& ring, std::size_t i) {
    const std::size_t n = ring.size();
    const Vec2& p = ring[(i + n - 1) % n].point;
    const Vec2& q = ring[i].point;
    const Vec2& r = ring[(i + 1) % n].point;
    if (!(cross(q - p, r - q) > 0)) return -1;
    for (std::size_t k = 2; k + 1 < n; ++k) {
        const Vec2& s = ring[(i + k) % n].point;
        if (is_left(p, q, s) && is_left(q, r, s) && is_left(r, p, s)) return -1;
    }
    return smallest_sine({p, q, r});
}

std::size_t best_ear(const std::vector<EarEntry>& ring) {
    std::size_t best = 0;
    double best_quality = -1;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const double quality = ear_quality(ring, i);
        if (quality <= best_quality) continue;
        best = i;
        best_quality = quality;
    }
    if (best_quality < 0) throw InternalError("a cell is not a polygon that can be triangulated");
    return best;
}

}  // namespace

GrainTriangulation::GrainTriangulation(const PeriodicMesh& cells)
    : lattice_(cells.lattice),
      vertices_(cells.vertices),
      halfedge_of_corner_(cells.corner_vertex.size()) {
    for (int f = 0; f < cells.n_faces(); ++f) triangulate(cells, f);
    for (int c = 0; c < cells.n_corners(); ++c) {
        link(halfedge_of_corner_[c], halfedge_of_corner_[cells.opposite[c]], Edge::kCell);
    }
    std::vector<int> all;
    for (int h = 0; h < n_halfedges(); ++h) all.push_back(h);
    restore_delaunay(std::move(all));
    // Flips have changed the halfedges of some corners.
    for (int h = 0; h < n_halfedges(); ++h) {
        checkpoint_each(h);
        if (edge_[h] == Edge::kFree) continue;
        int c = cells.face_begin[cell(h / 3)];
        while (cells.corner_vertex[c] != vertex(h) || cells.corner_offset[c] != corners_[h].offset)
            ++c;
        halfedge_of_corner_[c] = h;
    }
}

/// Triangulates a cell by cutting off ears, the best shaped first.
void GrainTriangulation::triangulate(const PeriodicMesh& cells, int f) {
    std::vector<EarEntry> ring;
    for (int c = cells.face_begin[f]; c < cells.face_begin[f + 1]; ++c) {
        ring.push_back({c, cells.point(c), -1});
    }
    // Returns the corner of the triangulation for an entry.
    const auto corner = [&](const EarEntry& entry) {
        return Corner{cells.corner_vertex[entry.corner], cells.corner_offset[entry.corner],
                      entry.point};
    };
    // Links halfedge h to the triangle across the entry, or notes it as part of the cell's edge.
    const auto close = [&](const EarEntry& entry, int h) {
        if (entry.halfedge >= 0) {
            link(h, entry.halfedge, Edge::kFree);
        } else {
            halfedge_of_corner_[entry.corner] = h;
        }
    };
    // Cut off ears until a triangle is left.
    while (ring.size() > 3) {
        const std::size_t n = ring.size();
        const std::size_t i = best_ear(ring);
        EarEntry& before = ring[(i + n - 1) % n];
        const int h = add_triangle(corner(before), corner(ring[i]), corner(ring[(i + 1) % n]), f);
        close(before, h);
        close(ring[i], h + 1);
        before.halfedge = h + 2;
        ring.erase(ring.begin() + std::ptrdiff_t(i));
    }
    const int h = add_triangle(corner(ring[0]), corner(ring[1]), corner(ring[2]), f);
    for (int k = 0; k < 3; ++k) close(ring[static_cast<std::size_t>(k)], h + k);
}

/// @returns the first halfedge of the new triangle.
int GrainTriangulation::add_triangle(const Corner& a, const Corner& b, const Corner& c, int cell) {
    const int first = n_halfedges();
    corners_.insert(corners_.end(), {a, b, c});
    opposite_.insert(opposite_.end(), 3, -1);
    edge_.insert(edge_.end(), 3, Edge::kFree);
    cell_.push_back(cell);
    return first;
}

void GrainTriangulation::set_triangle(int t, const Corner& a, const Corner& b, const Corner& c) {
    corners_[3 * t] = a;
    corners_[3 * t + 1] = b;
    corners_[3 * t + 2] = c;
}

void GrainTriangulation::link(int h, int o, Edge edge) {
    opposite_[h] = o;
    opposite_[o] = h;
    edge_[h] = edge;
    edge_[o] = edge;
}

void GrainTriangulation::make_guard(int h, Edge chord) {
    cell_[h / 3] = -1 - cell(h / 3);
    link(h, opposite_[h], Edge::kFirm);
    link(next(h), opposite_[next(h)], chord);
    link(previous(h), opposite_[previous(h)], Edge::kFirm);
}

/// Whether the two angles opposite a free edge sum to more than 180 degrees.
bool GrainTriangulation::must_flip(int h) const {
    if (edge_[h] != Edge::kFree) return false;
    const Vec2& a = point(h);
    const Vec2& b = point(next(h));
    const Vec2& c = point(previous(h));
    const Vec2& d = point(previous(opposite_[h]));
    const Vec2 ca = a - c;
    const Vec2 cb = b - c;
    const Vec2 da = a - d;
    const Vec2 db = b - d;
    // sin(gamma + delta) times the four lengths, whose squares have no product in large units.
    const double sine = cross(ca, cb) * da.dot(db) + ca.dot(cb) * cross(db, da);
    const double scale = std::sqrt(ca.squaredNorm() * cb.squaredNorm()) *
                         std::sqrt(da.squaredNorm() * db.squaredNorm());
    return sine < -kClearFlip * scale && cross(a - d, c - d) < 0 && cross(b - d, c - d) > 0;
}

/// Flips the edge between the triangles (a, b, c) and (b, a, d), which become (d, b, c) and (c, a,
/// d).
void GrainTriangulation::flip(int h) {
    const int o = opposite_[h];
    const int t = h / 3;
    const int s = o / 3;
    const Corner a = corners_[h];
    const Corner b = corners_[o];
    const Corner c = corners_[previous(h)];
    const Corner d = corners_[previous(o)];
    // Remember the four edges around the two triangles.
    const std::array around{next(h), previous(h), next(o), previous(o)};
    std::array<int, 4> across;
    std::array<Edge, 4> edges;
    for (std::size_t k = 0; k < 4; ++k) {
        across[k] = opposite_[around[k]];
        edges[k] = edge_[around[k]];
        // If two of the four are sides of the same edge, they are linked by their new indices.
        for (std::size_t l = 0; l < 4; ++l) {
            if (across[k] == around[l]) across[k] = -1 - static_cast<int>(l);
        }
    }
    // Replace the triangles and link the edges b c, c a, a d, d b.
    set_triangle(t, d, b, c);
    set_triangle(s, c, a, d);
    const std::array now{3 * t + 1, 3 * s, 3 * s + 1, 3 * t};
    for (std::size_t k = 0; k < 4; ++k) {
        const int there = across[k] < 0 ? now[static_cast<std::size_t>(-1 - across[k])] : across[k];
        link(now[k], there, edges[k]);
    }
    link(3 * t + 2, 3 * s + 2, Edge::kFree);
    touched_.push_back(t);
    touched_.push_back(s);
}

void GrainTriangulation::restore_delaunay(std::vector<int> suspects) {
    while (!suspects.empty()) {
        checkpoint();
        const int h = suspects.back();
        suspects.pop_back();
        if (!must_flip(h)) continue;
        const int t = h / 3;
        const int s = opposite_[h] / 3;
        flip(h);
        for (const int edge : {3 * t, 3 * t + 1, 3 * s, 3 * s + 1}) suspects.push_back(edge);
    }
}

int GrainTriangulation::split_edge(int h, double part) {
    touched_.clear();
    const int o = opposite_[h];
    const Corner a = corners_[h];
    const Corner b = corners_[next(h)];
    const Corner c = corners_[previous(h)];
    const Corner b_across = corners_[o];
    const Corner a_across = corners_[next(o)];
    const Corner d = corners_[previous(o)];
    const int v = n_vertices();
    // The representative of m lies on the side of the edge with the smaller offset.
    const Offset frame = a_across.offset - a.offset;
    const Vec2 here = a.point + part * (b.point - a.point);
    const Vec2 there = a_across.point + part * (b_across.point - a_across.point);
    const bool is_here = !(a_across.offset < a.offset);
    const Corner m{v, is_here ? Offset{} : -frame,
                   is_here ? here : Vec2(there + lattice_.translation(-frame))};
    const Corner m_across{v, is_here ? frame : Offset{},
                          is_here ? Vec2(here + lattice_.translation(frame)) : there};
    vertices_.push_back(is_here ? here : there);

    // Replace (a, b, c) by (a, m, c) and (m, b, c), and (b, a, d) by (b, m, d) and (m, a, d).
    const Edge edge = edge_[h];
    const int t = add_triangle(m, b, c, cell_[h / 3]);
    const int s = add_triangle(m_across, a_across, d, cell_[o / 3]);
    corners_[next(h)] = m;
    corners_[next(o)] = m_across;
    link(t + 1, opposite_[next(h)], edge_[next(h)]);
    link(s + 1, opposite_[next(o)], edge_[next(o)]);
    link(t + 2, next(h), Edge::kFree);
    link(s + 2, next(o), Edge::kFree);
    link(h, s, edge);
    link(t, o, edge);
    // Restore the Delaunay property around m.
    touched_.insert(touched_.end(), {h / 3, o / 3, t / 3, s / 3});
    restore_delaunay({previous(h), previous(o), t + 1, s + 1});
    return v;
}

int GrainTriangulation::insert(int t, const Vec2& p) {
    touched_.clear();
    const int v = n_vertices();
    vertices_.push_back(p);
    const Corner m{v, {}, p};
    const Corner a = corners_[3 * t];
    const Corner b = corners_[3 * t + 1];
    const Corner c = corners_[3 * t + 2];
    const int at_b = add_triangle(b, c, m, cell_[t]);
    const int at_c = add_triangle(c, a, m, cell_[t]);
    link(at_b, opposite_[3 * t + 1], edge_[3 * t + 1]);
    link(at_c, opposite_[3 * t + 2], edge_[3 * t + 2]);
    corners_[3 * t + 2] = m;
    link(3 * t + 1, at_b + 2, Edge::kFree);
    link(at_b + 1, at_c + 2, Edge::kFree);
    link(at_c + 1, 3 * t + 2, Edge::kFree);
    touched_.insert(touched_.end(), {t, at_b / 3, at_c / 3});
    restore_delaunay({3 * t, at_b, at_c});
    return v;
}

void GrainTriangulation::move(const std::vector<int>& star, const Vec2& p) {
    touched_.clear();
    std::vector<int> suspects;
    const Corner& any = corners_[star.front()];
    const Vec2 translation = any.point - vertices_[any.vertex];
    vertices_[any.vertex] = p - translation;
    for (const int h : star) {
        corners_[h].point = p;
        suspects.insert(suspects.end(), {h, next(h)});
        touched_.push_back(h / 3);
    }
    restore_delaunay(std::move(suspects));
}

PeriodicMesh GrainTriangulation::mesh(const PeriodicMesh& cells) const {
    PeriodicMesh mesh{.lattice = lattice_,
                      .kind = MeshKind::kGrains,
                      .vertices = vertices_,
                      .opposite = opposite_};
    const std::vector<int> sides = cell_sides(cells);
    for (int t = 0; t < n_triangles(); ++t) {
        checkpoint_each(t);
        for (int h = 3 * t; h < 3 * t + 3; ++h) {
            mesh.corner_vertex.push_back(corners_[h].vertex);
            mesh.corner_offset.push_back(corners_[h].offset);
            mesh.corner_face.push_back(t);
        }
        mesh.face_begin.push_back(3 * t + 3);
        mesh.site.push_back(cells.site[cell(t)]);
        mesh.whole_sides.push_back(sides[cell(t)]);
    }
    return mesh;
}

}  // namespace pcvt::plane
