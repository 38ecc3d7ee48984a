#include "mesher/box_outline.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "mesher/error.hpp"
#include "mesher/polygon.hpp"
#include "mesher/quality.hpp"
#include "mesher/voronoi.hpp"

namespace pcvt {
namespace {

/// A cell keeps this part of its area or more when vertices move onto the cut.
constexpr double kKeptArea = 0.5;
/// Where they would tear a cell, they move by this much less.
constexpr double kLessSnap = 4;

/// The two families of lines: u = k, which run along b, and v = l, which run along a.
constexpr std::array kAxes{0, 1};

/// Length units; an edge that near to a corner of the box passes through it.
double least_snap(const PeriodicMesh& cells) {
    return kSameVertex * std::sqrt(cells.lattice.area() / cells.n_faces());
}

/// A vertex orbit, its representative in the half-open box: u, v in [0, 1), 0 exactly on a line.
struct CutVertex {
    Vec2 u;
    bool on(int axis) const { return u[axis] == 0; }
};

/// An image of a vertex orbit. How it stands to each line is told by integers and by on(), never by
/// comparing coordinates.
struct Node {
    int vertex;
    Offset offset;
    friend bool operator==(const Node&, const Node&) = default;
};

int whole(Offset o, int axis) { return axis == 0 ? o.i : o.j; }
Offset along(int axis, int k) { return axis == 0 ? Offset{k, 0} : Offset{0, k}; }

class BoxCutter {
   public:
    BoxCutter(const PeriodicMesh& cells, const Vec2& origin, double snap)
        : cells_(cells), lattice_(cells.lattice), origin_(origin), snap_(snap) {
        for (int v = 0; v < cells.n_vertices(); ++v) add_cell_vertex(v);
    }

    /// Whether no cell was torn or squashed when vertices moved onto the cut.
    bool keeps_cells() const {
        if (n_at_corner_ > 1) return false;
        Polygon before;
        Polygon after;
        for (int f = 0; f < cells_.n_faces(); ++f) {
            before.clear();
            after.clear();
            for (int c = cells_.face_begin[f]; c < cells_.face_begin[f + 1]; ++c) {
                const Node node = corner_node(c);
                before.push_back(cells_.point(c));
                after.push_back(lattice_.to_plane({coordinate(node, 0), coordinate(node, 1)}));
            }
            if (polygon_area(after) < kKeptArea * polygon_area(before)) return false;
            if (crosses_itself(after, 0)) return false;
        }
        return true;
    }

    BoxCut cut() {
        cut_edges();
        const std::vector<int> sides = cell_sides(cells_);
        BoxCut box{{lattice_, TileKind::kCells, {}, {0}, {}, {}, {}, {}, {}}, 0};
        for (int f = 0; f < cells_.n_faces(); ++f) {
            for (const Nodes& piece : pieces_of(f)) {
                add_piece(f, piece, box.pieces);
                box.pieces.whole_sides.push_back(sides[f]);
            }
        }
        for (const CutVertex& vertex : vertices_) box.pieces.vertices.push_back(position(vertex));
        for (int v = 0; v < cells_.n_vertices(); ++v) {
            // Away from the cut a vertex stays where it was, but for a translation.
            if (vertices_[v].on(0) || vertices_[v].on(1)) continue;
            box.pieces.vertices[v] = cells_.vertices[v] - lattice_.translation(moved_[v]);
        }
        link_faces(box.pieces);
        box.shortest_edge = shortest_edge(box.pieces);
        return box;
    }

   private:
    using Nodes = std::vector<Node>;

    Vec2 position(const CutVertex& vertex) const {
        // Term by term, so that the sides along an axis of the plane are straight to the last bit.
        Vec2 p = origin_;
        if (!vertex.on(0)) p += vertex.u[0] * lattice_.a();
        if (!vertex.on(1)) p += vertex.u[1] * lattice_.b();
        return p;
    }
    double coordinate(const Node& node, int axis) const {
        return whole(node.offset, axis) + vertices_[node.vertex].u[axis];
    }
    /// The distance of two neighbouring lines of a family.
    double line_spacing(int axis) const {
        return lattice_.area() / (axis == 0 ? lattice_.b() : lattice_.a()).norm();
    }

    void add_cell_vertex(int v) {
        Vec2 u = lattice_.to_lattice(cells_.vertices[v] - origin_);
        Vec2 nearest = u.array().round();
        const bool at_corner = lattice_.to_plane(u - nearest).norm() < snap_;
        std::array<double, 2> distance;
        for (const int axis : kAxes) {
            distance[axis] = std::abs(u[axis] - nearest[axis]) * line_spacing(axis);
        }
        // Where the lines meet at a small angle, both may be near though the corner is not.
        const int nearer = distance[1] < distance[0] ? 1 : 0;
        for (const int axis : kAxes) {
            const bool snaps = at_corner || (distance[axis] < snap_ && axis == nearer);
            if (snaps) u[axis] = nearest[axis];
        }
        const Vec2 floor = u.array().floor();
        moved_.push_back({static_cast<int>(floor.x()), static_cast<int>(floor.y())});
        vertices_.push_back({u - floor});
        if (at_corner && corner_ < 0) corner_ = v;
        n_at_corner_ += at_corner;
    }

    int corner_vertex() {
        if (corner_ < 0) corner_ = add_vertex({0, 0});
        return corner_;
    }
    int add_vertex(const Vec2& u) {
        vertices_.push_back({u});
        return static_cast<int>(vertices_.size()) - 1;
    }

    Node corner_node(int c) const {
        const int v = cells_.corner_vertex[c];
        return {v, cells_.corner_offset[c] + moved_[v]};
    }

    /// Lines of a family that lie strictly between two nodes: first ... last, none if first > last.
    struct Lines {
        int first;
        int last;
    };
    Lines lines_between(const Node& p, const Node& q, int axis) const {
        const bool up = coordinate(p, axis) < coordinate(q, axis);
        const Node& low = up ? p : q;
        const Node& high = up ? q : p;
        const bool ends_on = vertices_[high.vertex].on(axis);
        return {whole(low.offset, axis) + 1, whole(high.offset, axis) - (ends_on ? 1 : 0)};
    }

    /// A node on an edge, at the part t of its way.
    struct Crossing {
        double t;
        Node node;
    };

    /// The corners of boxes through which the edge p q passes.
    std::vector<Crossing> corners_between(const Vec2& p, const Vec2& q, const Node& from,
                                          const Node& to) {
        std::vector<Crossing> found;
        const Vec2 way = lattice_.to_plane(q - p);
        for (const int axis : kAxes) {
            const Lines lines = lines_between(from, to, axis);
            for (int k = lines.first; k <= lines.last; ++k) {
                const double t = (k - p[axis]) / (q[axis] - p[axis]);
                Vec2 corner = (p + t * (q - p)).array().round();
                corner[axis] = k;
                const Vec2 from_p = lattice_.to_plane(corner - p);
                const double at = from_p.dot(way) / way.squaredNorm();
                if (std::abs(cross(way, from_p)) > least_snap(cells_) * way.norm() || at <= 0 ||
                    at >= 1)
                    continue;
                const Offset offset{static_cast<int>(corner.x()), static_cast<int>(corner.y())};
                const bool known = std::any_of(found.begin(), found.end(), [&](const Crossing& x) {
                    return x.node.offset == offset;
                });
                if (!known) found.push_back({at, {corner_vertex(), offset}});
            }
        }
        return found;
    }

    /// The nodes that the lines make on the edge which corner c leaves, in its order.
    std::vector<Node> cut_edge(int c) {
        const Node from = corner_node(c);
        const Node to = corner_node(cells_.next(c));
        const Vec2 p(coordinate(from, 0), coordinate(from, 1));
        const Vec2 q(coordinate(to, 0), coordinate(to, 1));
        std::vector<Crossing> crossings = corners_between(p, q, from, to);
        const std::size_t n_corners = crossings.size();
        for (const int axis : kAxes) {
            const Lines lines = lines_between(from, to, axis);
            for (int k = lines.first; k <= lines.last; ++k) {
                // A corner stands for the crossing of either line through it.
                const bool at_corner =
                    std::any_of(crossings.begin(), crossings.begin() + std::ptrdiff_t(n_corners),
                                [&](const Crossing& x) { return whole(x.node.offset, axis) == k; });
                if (at_corner) continue;
                const double t = (k - p[axis]) / (q[axis] - p[axis]);
                const double other = p[1 - axis] + t * (q[1 - axis] - p[1 - axis]);
                Vec2 u(0, 0);
                u[1 - axis] = other - std::floor(other);
                const int l = static_cast<int>(std::floor(other));
                crossings.push_back({t, {add_vertex(u), along(axis, k) + along(1 - axis, l)}});
            }
        }
        std::sort(crossings.begin(), crossings.end(),
                  [](const Crossing& x, const Crossing& y) { return x.t < y.t; });
        Nodes nodes;
        for (const Crossing& crossing : crossings) nodes.push_back(crossing.node);
        return nodes;
    }

    void cut_edges() {
        on_edge_.resize(static_cast<std::size_t>(cells_.n_corners()));
        for (int c = 0; c < cells_.n_corners(); ++c) {
            const int o = cells_.opposite[c];
            if (o < c) continue;
            on_edge_[c] = cut_edge(c);
            const Offset frame = cells_.frame_across(c);
            for (auto node = on_edge_[c].rbegin(); node != on_edge_[c].rend(); ++node) {
                on_edge_[o].push_back({node->vertex, node->offset - frame});
            }
        }
    }

    /// -1, 0 or 1: before, on or behind line k of a family.
    int side(const Node& node, int axis, int k) const {
        const int here = whole(node.offset, axis);
        if (here != k) return here < k ? -1 : 1;
        return vertices_[node.vertex].on(axis) ? 0 : 1;
    }

    /// What splits a polygon in two: line k of a family, run through so that the pieces of side
    /// `kept` lie on its left.
    struct Line {
        int axis;
        int k;
        int kept;
    };
    bool comes_before(const Node& p, const Node& q, const Line& line) const {
        const int axis = 1 - line.axis;
        const bool left_is_behind = (line.axis == 1) == lattice_.right_handed();
        const bool rising = left_is_behind == (line.kept > 0);
        const Node& first = rising ? p : q;
        const Node& second = rising ? q : p;
        const int i = whole(first.offset, axis);
        const int j = whole(second.offset, axis);
        if (i != j) return i < j;
        return vertices_[first.vertex].u[axis] < vertices_[second.vertex].u[axis];
    }

    /// The corners of boxes strictly between two neighbouring nodes on a line, in this order.
    Nodes corners_on_line(const Node& from, const Node& to, const Line& line) {
        const int axis = 1 - line.axis;
        const Lines lines = lines_between(from, to, axis);
        Nodes corners;
        for (int l = lines.first; l <= lines.last; ++l) {
            corners.push_back({corner_vertex(), along(line.axis, line.k) + along(axis, l)});
        }
        if (coordinate(to, axis) < coordinate(from, axis)) {
            std::reverse(corners.begin(), corners.end());
        }
        return corners;
    }

    bool turns_left(const Node& p, const Node& q, const Node& r) const {
        const auto point = [&](const Node& node) {
            return lattice_.to_plane({coordinate(node, 0), coordinate(node, 1)});
        };
        return cross(point(q) - point(p), point(r) - point(q)) > 0;
    }

    /// A part of a polygon's boundary that lies on the kept side, with its ends on the line.
    struct Chain {
        Nodes nodes;
        bool taken = false;
    };

    std::vector<Chain> chains_of(const Nodes& polygon, const Line& line) const {
        const int n = static_cast<int>(polygon.size());
        const auto at = [&](int i) { return polygon[(i + n) % n]; };
        const auto beside = [&](int i) { return side(at(i), line.axis, line.k) == line.kept; };
        // A corner that only touches the line does not end a chain.
        const auto kept = [&](int i) {
            return beside(i) || (side(at(i), line.axis, line.k) == 0 && beside(i - 1) &&
                                 beside(i + 1) && turns_left(at(i - 1), at(i), at(i + 1)));
        };
        std::vector<Chain> chains;
        for (int i = 0; i < n; ++i) {
            if (!kept(i) || kept(i - 1)) continue;
            Chain chain;
            int j = i - 1;
            do {
                chain.nodes.push_back(at(j));
            } while (kept(++j));
            chain.nodes.push_back(at(j));
            chains.push_back(std::move(chain));
        }
        return chains;
    }

    /// Every node of the polygon on the line, and the corners of boxes between them, in order.
    Nodes nodes_on_line(const Nodes& polygon, const Line& line) {
        Nodes on_line;
        for (const Node& node : polygon) {
            if (side(node, line.axis, line.k) == 0) on_line.push_back(node);
        }
        std::sort(on_line.begin(), on_line.end(),
                  [&](const Node& p, const Node& q) { return comes_before(p, q, line); });
        Nodes all;
        for (const Node& node : on_line) {
            if (!all.empty()) {
                const Nodes corners = corners_on_line(all.back(), node, line);
                all.insert(all.end(), corners.begin(), corners.end());
            }
            all.push_back(node);
        }
        return all;
    }

    /// The ends of the chains along the line take turns: where one ends the polygon goes on along
    /// the line, up to the next one that starts.
    static int chain_after(const Node& end, const std::vector<Chain>& chains,
                           const Nodes& on_line) {
        const auto stop = std::find(on_line.begin(), on_line.end(), end);
        for (auto node = stop; node != on_line.end() && ++node != on_line.end();) {
            for (std::size_t k = 0; k < chains.size(); ++k) {
                if (chains[k].nodes.front() == *node) return static_cast<int>(k);
            }
        }
        throw InternalError("a cell could not be cut along the box");
    }

    /// The parts of the polygon on the kept side of a line that it crosses.
    std::vector<Nodes> kept_parts(const Nodes& polygon, const Line& line) {
        std::vector<Chain> chains = chains_of(polygon, line);
        const Nodes on_line = nodes_on_line(polygon, line);
        std::vector<Nodes> parts;
        for (std::size_t first = 0; first < chains.size(); ++first) {
            if (chains[first].taken) continue;
            Nodes part;
            for (auto k = first; !chains[k].taken;) {
                chains[k].taken = true;
                const Nodes& chain = chains[k].nodes;
                part.insert(part.end(), chain.begin(), chain.end() - 1);
                k = static_cast<std::size_t>(chain_after(chain.back(), chains, on_line));
                const auto from = std::find(on_line.begin(), on_line.end(), chain.back());
                const auto to = std::find(from, on_line.end(), chains[k].nodes.front());
                part.insert(part.end(), from, to);
            }
            parts.push_back(std::move(part));
        }
        return parts;
    }

    /// Cuts each polygon along every line of a family that crosses it.
    std::vector<Nodes> cut_along(const std::vector<Nodes>& polygons, int axis) {
        std::vector<Nodes> done;
        for (Nodes polygon : polygons) {
            int k = std::numeric_limits<int>::max();
            for (const Node& node : polygon) k = std::min(k, whole(node.offset, axis) + 1);
            std::vector<Nodes> rest{std::move(polygon)};
            for (; !rest.empty(); ++k) {
                std::vector<Nodes> behind;
                for (const Nodes& part : rest) split(part, axis, k, done, behind);
                rest = std::move(behind);
            }
        }
        return done;
    }
    void split(const Nodes& polygon, int axis, int k, std::vector<Nodes>& before,
               std::vector<Nodes>& behind) {
        const auto any_at = [&](int wanted) {
            return std::any_of(polygon.begin(), polygon.end(),
                               [&](const Node& node) { return side(node, axis, k) == wanted; });
        };
        if (!any_at(1) || !any_at(-1)) {
            (any_at(1) ? behind : before).push_back(polygon);
            return;
        }
        for (Nodes& part : kept_parts(polygon, {axis, k, -1})) before.push_back(std::move(part));
        for (Nodes& part : kept_parts(polygon, {axis, k, 1})) behind.push_back(std::move(part));
    }

    std::vector<Nodes> pieces_of(int f) {
        Nodes polygon;
        for (int c = cells_.face_begin[f]; c < cells_.face_begin[f + 1]; ++c) {
            polygon.push_back(corner_node(c));
            polygon.insert(polygon.end(), on_edge_[c].begin(), on_edge_[c].end());
        }
        return cut_along(cut_along({polygon}, 0), 1);
    }

    /// Moves the piece into the box and appends it.
    void add_piece(int f, const Nodes& piece, PeriodicMesh& mesh) const {
        Offset box = piece.front().offset;
        for (const Node& node : piece) {
            box = {std::min(box.i, node.offset.i), std::min(box.j, node.offset.j)};
        }
        for (const Node& node : piece) {
            mesh.corner_vertex.push_back(node.vertex);
            mesh.corner_offset.push_back(node.offset - box);
        }
        mesh.face_begin.push_back(mesh.n_corners());
        mesh.site.push_back(cells_.site[f]);
        mesh.site_points.push_back(cells_.site_points[f] - lattice_.translation(box));
    }

    double shortest_edge(const PeriodicMesh& pieces) const {
        double shortest = std::numeric_limits<double>::infinity();
        const auto on_cut = [&](int c) {
            const CutVertex& vertex = vertices_[pieces.corner_vertex[c]];
            return vertex.on(0) || vertex.on(1);
        };
        for (int c = 0; c < pieces.n_corners(); ++c) {
            const int next = pieces.next(c);
            if (!on_cut(c) && !on_cut(next)) continue;
            shortest = std::min(shortest, (pieces.point(next) - pieces.point(c)).norm());
        }
        return shortest;
    }

    const PeriodicMesh& cells_;
    const Lattice& lattice_;
    Vec2 origin_;
    double snap_;
    /// Those of the cells, then those that the cut makes.
    std::vector<CutVertex> vertices_;
    /// By which offset a vertex of the cells was moved into the box.
    std::vector<Offset> moved_;
    int corner_ = -1;
    int n_at_corner_ = 0;
    /// For each corner the nodes on the edge that it leaves.
    std::vector<Nodes> on_edge_;
};

bool are_polygons(const PeriodicMesh& mesh) {
    Polygon polygon;
    for (int f = 0; f < mesh.n_faces(); ++f) {
        polygon.clear();
        for (int c = mesh.face_begin[f]; c < mesh.face_begin[f + 1]; ++c) {
            polygon.push_back(mesh.point(c));
        }
        if (!(polygon_area(polygon) > 0) || crosses_itself(polygon, 0)) return false;
    }
    return true;
}

}  // namespace

BoxCut cut_along_box(const PeriodicMesh& cells, const Vec2& origin, double snap) {
    const double least = least_snap(cells);
    for (; snap > least; snap /= kLessSnap) {
        BoxCutter cutter(cells, origin, snap);
        if (!cutter.keeps_cells()) continue;
        BoxCut box = cutter.cut();
        if (are_polygons(box.pieces)) return box;
    }
    return BoxCutter(cells, origin, least).cut();
}

}  // namespace pcvt
