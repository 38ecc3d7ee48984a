#include "mesher/space/grains/shared_moves.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include "mesher/base/checkpoint.hpp"
#include "mesher/space/grains/cell_filling.hpp"

namespace pcvt::space {
namespace {

constexpr double kSharedProbeGain = 1e-9;
constexpr double kGain = 1e-6;
/// Both new triangles have at least this part of the area of an old one.
constexpr double kLeastArea = 1e-3;
/// Steps of the search over the shortest edge at the node.
constexpr double kFirstSharedStep = 0.25;
constexpr double kLastSharedStep = 0.02;

}  // namespace

SharedMoves::SharedMoves(const CellComplex& complex, GrainSurface& surface,
                         std::vector<CellHull>& hulls, std::vector<CellTetrahedra>& cells)
    : complex_(complex),
      surface_(surface),
      hulls_(hulls),
      cells_(cells),
      uses_(surface.nodes.size()) {
    for (int c = 0; c < static_cast<int>(hulls.size()); ++c) {
        const std::vector<NodeImage>& images = hulls[c].images;
        for (int v = 0; v < static_cast<int>(images.size()); ++v) {
            uses_[images[v].vertex].push_back({c, v});
        }
    }
}

/// The edges of the triangles of a face, so that both triangles of an inner edge follow each other.
std::vector<SharedMoves::FaceEdge> SharedMoves::face_edges(int f) const {
    std::vector<FaceEdge> edges;
    const std::vector<SurfaceTriangle>& triangles = surface_.triangles[f];
    for (int t = 0; t < static_cast<int>(triangles.size()); ++t) {
        for (int k = 0; k < 3; ++k) {
            const auto [low, high] =
                std::minmax(triangles[t][(k + 1) % 3], triangles[t][(k + 2) % 3]);
            edges.push_back({low, high, t, triangles[t][k]});
        }
    }
    std::sort(edges.begin(), edges.end(), [](const FaceEdge& e, const FaceEdge& g) {
        return std::tie(e.low, e.high, e.triangle) < std::tie(g.low, g.high, g.triangle);
    });
    return edges;
}

void SharedMoves::flip_edges() {
    for (int f = 0; f < complex_.n_faces(); ++f) {
        checkpoint();
        flip_face(f);
    }
}

void SharedMoves::flip_face(int f) {
    const std::vector<FaceEdge> edges = face_edges(f);
    std::vector<char> touched(surface_.triangles[f].size(), 0);
    for (std::size_t k = 0; k + 1 < edges.size(); ++k) {
        const FaceEdge& left = edges[k];
        const FaceEdge& right = edges[k + 1];
        if (left.low != right.low || left.high != right.high) continue;
        if (touched[left.triangle] != 0 || touched[right.triangle] != 0) continue;
        if (!flip(f, left, right)) continue;
        touched[left.triangle] = touched[right.triangle] = 1;
    }
}

/// Whether the triangles (c, d, b) and (d, c, a) lie in the quadrilateral of (a, b, c) and
/// (b, a, d).
bool SharedMoves::leaves_area(const NodeImage& a, const NodeImage& b, const NodeImage& c,
                              const NodeImage& d) const {
    const auto at = [&](const NodeImage& image) { return surface_.position(complex_, image); };
    const auto area = [&](const NodeImage& p, const NodeImage& q, const NodeImage& r) {
        return cross_product(at(q) - at(p), at(r) - at(p));
    };
    const Vec3 old = area(a, b, c);
    const double least = kLeastArea * squared_length(old);
    return dot_product(area(c, d, b), old) > least && dot_product(area(d, c, a), old) > least;
}

bool SharedMoves::plan(int cell, const Offset& shift, const std::array<NodeImage, 4>& corners,
                       FlipPlan& plan) {
    const auto vertex = [&](int k) {
        return hulls_[cell].find({corners[k].vertex, corners[k].offset - shift});
    };
    return TetrahedronFlips(cells_[cell])
        .plan_on_hull(vertex(0), vertex(1), vertex(2), vertex(3), plan);
}

void SharedMoves::carry_out(int cell, const Offset& shift, const std::array<NodeImage, 4>& corners,
                            const FlipPlan& plan) {
    const auto vertex = [&](int k) {
        return hulls_[cell].find({corners[k].vertex, corners[k].offset - shift});
    };
    const int a = vertex(0);
    const int b = vertex(1);
    const int c = vertex(2);
    const int d = vertex(3);
    cells_[cell].replace(plan.old, plan.fresh,
                         {.gone = {{a, b, c}, {a, b, d}}, .come = {{c, d, a}, {c, d, b}}});
}

/// Replaces the edge between two triangles of a face by that between their apexes, if the smallest
/// sine of the tetrahedra at it in both cells rises.
bool SharedMoves::flip(int f, const FaceEdge& left, const FaceEdge& right) {
    const CellFace& face = complex_.faces[f];
    std::vector<SurfaceTriangle>& triangles = surface_.triangles[f];
    // The triangle on the left is (a, b, c).
    NodeImage a = left.low;
    NodeImage b = left.high;
    const SurfaceTriangle& t = triangles[left.triangle];
    for (int k = 0; k < 3; ++k) {
        if (t[k] == b && t[(k + 1) % 3] == a) std::swap(a, b);
    }
    const NodeImage c = left.apex;
    const NodeImage d = right.apex;
    if (!leaves_area(a, b, c, d)) return false;
    const std::array<NodeImage, 4> corners{a, b, c, d};
    if (!plan(face.cell, {}, corners, first_) ||
        !plan(face.neighbour, face.offset, corners, second_)) {
        return false;
    }
    const double before = std::min(first_.before, second_.before);
    const double after = std::min(first_.after, second_.after);
    if (before > kTargetSine || after <= before + kGain) return false;
    if (face.cell == face.neighbour) {
        // A cell that is its own neighbour: the two plans must not share a tetrahedron.
        for (const int s : first_.old) {
            if (std::find(second_.old.begin(), second_.old.end(), s) != second_.old.end()) {
                return false;
            }
        }
    }
    // Plans name vertices, so the first one leaves the numbers of the second as they are, except
    // where both are of one cell: those that are alive keep their numbers.
    carry_out(face.cell, {}, corners, first_);
    carry_out(face.neighbour, face.offset, corners, second_);
    triangles[left.triangle] = {a, d, c};
    triangles[right.triangle] = {b, c, d};
    return true;
}

void SharedMoves::move_nodes() {
    for (int node = 0; node < static_cast<int>(surface_.nodes.size()); ++node) {
        checkpoint_each(node, 64);
        move(node);
    }
}

std::vector<Vec3> SharedMoves::directions(int node) const {
    const SurfaceNode& at = surface_.nodes[node];
    if (at.dimension == 1) {
        const CellEdge& edge = surface_.edges.edges[at.carrier];
        const Vec3 along = unit_vector(complex_.position(edge.to) - complex_.position(edge.from));
        return {along, -along};
    }
    const double half = 0.5;
    const double root = 0.8660254037844386;
    const FacePlane plane = face_plane(complex_, at.carrier);
    const Vec3 left = half * plane.x + root * plane.y;
    const Vec3 right = half * plane.x - root * plane.y;
    return {plane.x, left, -right, -plane.x, -left, right};
}

void SharedMoves::collect_stars(int node) {
    around_.clear();
    for (const Use& use : uses_[node]) {
        const CellTetrahedra& cell = cells_[use.cell];
        cell.find_star(use.vertex, star_);
        for (const int t : star_) around_.push_back({cell.quality(t), use.cell, t});
    }
    // The worst come first, since most probes fail there.
    std::sort(around_.begin(), around_.end(), [](const Around& s, const Around& t) {
        return std::tie(s.quality, s.cell, s.tetrahedron) <
               std::tie(t.quality, t.cell, t.tetrahedron);
    });
}

void SharedMoves::place(int node, const Vec3& at) {
    surface_.nodes[node].position = at;
    for (const Use& use : uses_[node]) {
        CellHull& hull = hulls_[use.cell];
        hull.points[use.vertex] = at + complex_.reduced.translation(hull.images[use.vertex].offset);
        cells_[use.cell].set_point(use.vertex, hull.points[use.vertex]);
    }
}

/// The smallest sine round all images of a node at another place, where it stays.
double SharedMoves::worst_with(int node, const Vec3& at, double least) {
    place(node, at);
    double worst = kUnlimited;
    for (const Around& t : around_) {
        const CellTetrahedra& cell = cells_[t.cell];
        const FourCorners& c = cell.corners(t.tetrahedron);
        worst = std::min(worst, smallest_sine(cell.point(c[0]), cell.point(c[1]), cell.point(c[2]),
                                              cell.point(c[3])));
        if (worst <= least) break;
    }
    return worst;
}

bool SharedMoves::move(int node) {
    if (surface_.nodes[node].dimension == 0) return false;
    collect_stars(node);
    const double start = around_[0].quality;
    if (start > kTargetSine) return false;
    const Vec3 from = surface_.nodes[node].position;
    double shortest = kUnlimited;
    for (const Use& use : uses_[node]) {
        const CellTetrahedra& cell = cells_[use.cell];
        cell.find_star(use.vertex, star_);
        for (const int t : star_) {
            for (const int v : cell.corners(t)) {
                if (v == use.vertex) continue;
                shortest =
                    std::min(shortest, squared_distance(cell.point(v), cell.point(use.vertex)));
            }
        }
    }
    shortest = std::sqrt(shortest);
    double best = start;
    Vec3 x = from;
    const std::vector<Vec3> ways = directions(node);
    for (double step = kFirstSharedStep; step > kLastSharedStep; step /= 2) {
        for (const Vec3& way : ways) {
            const Vec3 probe = x + step * shortest * way;
            const double worst = worst_with(node, probe, best);
            if (worst > best + kSharedProbeGain) {
                best = worst;
                x = probe;
            }
        }
    }
    if (best <= start + kGain) x = from;
    place(node, x);
    for (const Around& t : around_) cells_[t.cell].update_quality(std::array{t.tetrahedron});
    return x != from;
}

}  // namespace pcvt::space
