#include "mesher/plane/mesh/box_outline.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>
#include <utility>

#include "mesher/base/checkpoint.hpp"
#include "mesher/base/error.hpp"
#include "mesher/plane/geometry/polygon.hpp"
#include "mesher/plane/mesh/box_lines.hpp"
#include "mesher/plane/mesh/valence.hpp"
#include "mesher/plane/mesh/voronoi.hpp"

namespace pcvt::plane {
namespace {

/// A cell keeps at least this fraction of its area when vertices move onto the cut.
constexpr double kAreaBesideCut = 0.5;
/// The factor by which the snapping distance is reduced if it would tear a cell.
constexpr double kLessSnapForCells = 4;

/// Returns the smallest distance over which vertices and edges are moved, length units.
double least_snap(const PeriodicMesh& cells) {
    return kSameVertex * std::sqrt(cells.lattice.area() / cells.n_faces());
}

class BoxCutter {
   public:
    BoxCutter(const PeriodicMesh& cells, const Vec2& origin, const SnapReach& reach,
              const BoxSnaps& earlier)
        : cells_(cells),
          lattice_(cells.lattice),
          origin_(origin),
          snapper_(lattice_, reach, earlier),
          lines_(lattice_) {
        snaps_.still = earlier.still;
        for (int v = 0; v < cells.n_vertices(); ++v) add_cell_vertex(v);
    }

    /// Whether all cells are still simple and not squashed after vertices moved onto the cut.
    bool keeps_cells() const {
        if (n_at_corner_ > 1) return false;
        Polygon before;
        Polygon after;
        for (int f = 0; f < cells_.n_faces(); ++f) {
            checkpoint_each(f);
            face_polygon(cells_, f, before);
            after.clear();
            for (int c = cells_.face_begin[f]; c < cells_.face_begin[f + 1]; ++c) {
                after.push_back(lattice_.to_position(lines_.coordinates(corner_node(c))));
            }
            if (polygon_area(after) < kAreaBesideCut * polygon_area(before)) return false;
            if (crosses_itself(after, 0)) return false;
        }
        return true;
    }

    /// @returns nothing if vertices and edges that moved onto the cut leave a piece without area,
    ///          or lie there in another order than on the boundary of their cell.
    std::optional<BoxCut> cut() {
        cut_edges();
        BoxCut box{{.lattice = lattice_, .kind = MeshKind::kVoronoi}, 0, {}};
        try {
            if (!add_pieces(box.pieces)) return std::nullopt;
            link_faces(box.pieces);
        } catch (const InternalError&) {
            return std::nullopt;
        }
        box.shortest_edge = shortest_edge(box.pieces);
        box.snaps = snaps_;
        return box;
    }

    /// Whether cut() has left at most one vertex or one edge of the cells at the corner of the box.
    bool passes_corner_once() const { return n_at_corner_ <= 1; }

    /// Whether no two vertices on a line have moved to one point.
    bool has_distinct_vertices() const {
        std::vector<Vec2> on_lines;
        for (int v = 0; v < lines_.n_vertices(); ++v) {
            if (lines_.on_any_line(v)) on_lines.push_back(lines_.vertex(v));
        }
        const auto before = [](const Vec2& p, const Vec2& q) {
            return std::tie(p.x(), p.y()) < std::tie(q.x(), q.y());
        };
        std::sort(on_lines.begin(), on_lines.end(), before);
        return std::adjacent_find(
                   on_lines.begin(), on_lines.end(), [&](const Vec2& p, const Vec2& q) {
                       return lattice_.to_position(q - p).norm() < least_snap(cells_);
                   }) == on_lines.end();
    }

   private:
    Vec2 position(int v) const {
        // A vertex off the cut keeps its position up to a translation.
        if (!lines_.on_any_line(v)) return cells_.vertices[v] - lattice_.translation(moved_[v]);
        // The terms are added one by one so that sides parallel to an axis are exactly straight.
        Vec2 p = origin_;
        if (!lines_.on_line(v, 0)) p += lines_.vertex(v)[0] * lattice_.a();
        if (!lines_.on_line(v, 1)) p += lines_.vertex(v)[1] * lattice_.b();
        return p;
    }
    void add_cell_vertex(int v) {
        Vec2 u = lattice_.to_lattice(cells_.vertices[v] - origin_);
        const OnLines on = snapper_.lines_near(v, u);
        for (const int axis : BoxLines::kAxes) {
            if (on[axis]) u[axis] = std::round(u[axis]);
        }
        snaps_.vertices.push_back(on);
        const Vec2 floor = u.array().floor();
        moved_.push_back({static_cast<int>(floor.x()), static_cast<int>(floor.y())});
        lines_.add_vertex(u - floor);
        n_at_corner_ += on[0] && on[1];
    }

    BoxNode corner_node(int c) const {
        const int v = cells_.corner_vertex[c];
        return {v, cells_.corner_offset[c] + moved_[v]};
    }

    /// A node on an edge, at the fraction t of the edge.
    struct Crossing {
        double t;
        BoxNode node;
    };

    /// Returns the box corners through which the edge p q, which corner c leaves, passes.
    std::vector<Crossing> corners_between(int c, const Vec2& p, const Vec2& q, const BoxNode& from,
                                          const BoxNode& to) {
        std::vector<Crossing> found;
        const Vec2 way = lattice_.to_position(q - p);
        const bool is_still = snaps_.is_still(cells_.corner_vertex[c]) &&
                              snaps_.is_still(cells_.corner_vertex[cells_.next(c)]);
        for (const int axis : BoxLines::kAxes) {
            const BoxLines::Range lines = lines_.lines_between(from, to, axis);
            for (int k = lines.first; k <= lines.last; ++k) {
                const double t = (k - p[axis]) / (q[axis] - p[axis]);
                Vec2 corner = (p + t * (q - p)).array().round();
                corner[axis] = k;
                const Vec2 from_p = lattice_.to_position(corner - p);
                const double at = from_p.dot(way) / way.squaredNorm();
                const Offset offset{static_cast<int>(corner.x()), static_cast<int>(corner.y())};
                const double distance = std::abs(cross(way, from_p)) / way.norm();
                if (at <= 0 || at >= 1 || !snapper_.is_bent({c, offset}, distance, is_still)) {
                    continue;
                }
                const bool known = std::any_of(found.begin(), found.end(), [&](const Crossing& x) {
                    return x.node.offset == offset;
                });
                if (!known) found.push_back({at, {lines_.corner_vertex(), offset}});
            }
        }
        return found;
    }

    static bool comes_first(const Crossing& x, const Crossing& y) { return x.t < y.t; }

    /// Returns the nodes where the lines cross the edge that corner c leaves, in the order along
    /// the edge.
    std::vector<BoxNode> cut_edge(int c) {
        const BoxNode from = corner_node(c);
        const BoxNode to = corner_node(cells_.next(c));
        const Vec2 p = lines_.coordinates(from);
        const Vec2 q = lines_.coordinates(to);
        // The edge bends at the box corners near it, and is straight between them. From here on,
        // the fraction t counts the straight parts.
        std::vector<Crossing> crossings = corners_between(c, p, q, from, to);
        std::stable_sort(crossings.begin(), crossings.end(), comes_first);
        std::vector<Vec2> path{p};
        for (Crossing& corner : crossings) {
            snaps_.bends.push_back({c, corner.node.offset});
            corner.t = static_cast<double>(path.size());
            path.push_back(lines_.coordinates(corner.node));
        }
        path.push_back(q);
        // Add a new vertex wherever else a line crosses the edge.
        for (const int axis : BoxLines::kAxes) {
            const BoxLines::Range lines = lines_.lines_between(from, to, axis);
            for (int k = lines.first; k <= lines.last; ++k) {
                // A corner replaces the crossings of both lines through it.
                const bool at_corner = std::any_of(path.begin() + 1, path.end() - 1,
                                                   [&](const Vec2& u) { return u[axis] == k; });
                if (!at_corner) crossings.push_back(cross_line(path, axis, k));
            }
        }
        std::stable_sort(crossings.begin(), crossings.end(), comes_first);
        BoxPolygon nodes;
        for (const Crossing& crossing : crossings) nodes.push_back(crossing.node);
        return nodes;
    }

    /// Adds the vertex where a path crosses line k of a family.
    /// @pre The ends of the path lie on both sides of the line.
    Crossing cross_line(const std::vector<Vec2>& path, int axis, int k) {
        const auto is_before = [&](std::size_t i) { return path[i][axis] < k; };
        std::size_t part = 0;
        // The last part is the one where rounding moves an end onto the line.
        while (part + 2 < path.size() && is_before(part) == is_before(part + 1)) ++part;
        const Vec2& p = path[part];
        const Vec2& q = path[part + 1];
        const double t = (k - p[axis]) / (q[axis] - p[axis]);
        const double other = p[1 - axis] + t * (q[1 - axis] - p[1 - axis]);
        Vec2 u(0, 0);
        u[1 - axis] = other - std::floor(other);
        const int l = static_cast<int>(std::floor(other));
        const Offset offset = BoxLines::along(axis, k) + BoxLines::along(1 - axis, l);
        return {static_cast<double>(part) + t, {lines_.add_vertex(u), offset}};
    }

    void cut_edges() {
        on_edge_.resize(static_cast<std::size_t>(cells_.n_corners()));
        for (int c = 0; c < cells_.n_corners(); ++c) {
            checkpoint_each(c);
            const int o = cells_.opposite[c];
            if (o < c) continue;
            on_edge_[c] = cut_edge(c);
            n_at_corner_ +=
                std::any_of(on_edge_[c].begin(), on_edge_[c].end(),
                            [&](const BoxNode& node) { return lines_.is_corner(node.vertex); });
            const Offset frame = cells_.frame_across(c);
            for (auto node = on_edge_[c].rbegin(); node != on_edge_[c].rend(); ++node) {
                on_edge_[o].push_back({node->vertex, node->offset - frame});
            }
        }
    }

    std::vector<BoxPolygon> pieces_of(int f) {
        BoxPolygon polygon;
        for (int c = cells_.face_begin[f]; c < cells_.face_begin[f + 1]; ++c) {
            polygon.push_back(corner_node(c));
            polygon.insert(polygon.end(), on_edge_[c].begin(), on_edge_[c].end());
        }
        return lines_.split(polygon);
    }

    /// Returns whether all pieces are polygons.
    bool add_pieces(PeriodicMesh& pieces) {
        const std::vector<int> sides = cell_sides(cells_);
        for (int f = 0; f < cells_.n_faces(); ++f) {
            checkpoint_each(f);
            for (const BoxPolygon& piece : pieces_of(f)) {
                if (!is_polygon(piece)) return false;
                add_piece(f, piece, pieces);
                pieces.whole_sides.push_back(sides[f]);
            }
        }
        for (int v = 0; v < lines_.n_vertices(); ++v) pieces.vertices.push_back(position(v));
        return true;
    }

    /// Whether the piece has three nodes or more, each once.
    static bool is_polygon(const BoxPolygon& piece) {
        const auto before = [](const BoxNode& p, const BoxNode& q) {
            return std::tie(p.vertex, p.offset) < std::tie(q.vertex, q.offset);
        };
        BoxPolygon sorted = piece;
        std::sort(sorted.begin(), sorted.end(), before);
        return sorted.size() >= 3 &&
               std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end();
    }

    /// Moves the piece into the box and appends it.
    void add_piece(int f, const BoxPolygon& piece, PeriodicMesh& mesh) const {
        Offset box = piece.front().offset;
        for (const BoxNode& node : piece) {
            box = {std::min(box.i, node.offset.i), std::min(box.j, node.offset.j)};
        }
        for (const BoxNode& node : piece) {
            mesh.corner_vertex.push_back(node.vertex);
            mesh.corner_offset.push_back(node.offset - box);
        }
        mesh.face_begin.push_back(mesh.n_corners());
        mesh.site.push_back(cells_.site[f]);
        mesh.site_points.push_back(cells_.site_points[f] - lattice_.translation(box));
    }

    double shortest_edge(const PeriodicMesh& pieces) const {
        double shortest = std::numeric_limits<double>::infinity();
        const auto on_cut = [&](int c) { return lines_.on_any_line(pieces.corner_vertex[c]); };
        for (int c = 0; c < pieces.n_corners(); ++c) {
            checkpoint_each(c);
            const int next = pieces.next(c);
            if (!on_cut(c) && !on_cut(next)) continue;
            shortest = std::min(shortest, (pieces.point(next) - pieces.point(c)).norm());
        }
        return shortest;
    }

    const PeriodicMesh& cells_;
    const Lattice& lattice_;
    Vec2 origin_;
    BoxSnapper snapper_;
    BoxSnaps snaps_;
    /// Holds the vertices of the cells first, then the vertices that the cut adds.
    BoxLines lines_;
    /// For each vertex of the cells, the offset of the box that contained it.
    std::vector<Offset> moved_;
    /// The vertices of the cells that lie at the corner of the box, and the edges through it.
    int n_at_corner_ = 0;
    /// For each corner, the nodes on the edge that it leaves.
    std::vector<BoxPolygon> on_edge_;
};

bool are_polygons(const PeriodicMesh& mesh) {
    Polygon polygon;
    for (int f = 0; f < mesh.n_faces(); ++f) {
        checkpoint_each(f);
        face_polygon(mesh, f, polygon);
        if (!(polygon_area(polygon) > 0) || crosses_itself(polygon, 0)) return false;
    }
    return true;
}

}  // namespace

BoxCut cut_along_box(const PeriodicMesh& cells, const Vec2& origin, double snap,
                     const BoxSnaps& earlier) {
    const double least = least_snap(cells);
    for (; snap > least; snap /= kLessSnapForCells) {
        BoxCutter cutter(cells, origin, reach_after(earlier, snap, least), earlier);
        if (!cutter.keeps_cells()) continue;
        std::optional<BoxCut> box = cutter.cut();
        if (!box || !cutter.passes_corner_once() || !cutter.has_distinct_vertices()) continue;
        if (are_polygons(box->pieces)) return std::move(*box);
    }
    std::optional<BoxCut> box = BoxCutter(cells, origin, {least, least, least}, earlier).cut();
    if (!box) throw InternalError("the cells could not be cut along the box");
    return std::move(*box);
}

std::optional<BoxCut> cut_along_box_as_before(const PeriodicMesh& cells, const Vec2& origin,
                                              const BoxSnaps& earlier) {
    const double least = least_snap(cells);
    const SnapReach reach{least, std::numeric_limits<double>::infinity(), least};
    return BoxCutter(cells, origin, reach, earlier).cut();
}

}  // namespace pcvt::plane
