#include "mesher/plane/grains/corner_guards.hpp"

#include <algorithm>
#include <limits>

#include "mesher/base/checkpoint.hpp"
#include "mesher/plane/grains/triangle_shape.hpp"

namespace pcvt::plane {
namespace {

/// A guard's side is at most this fraction of its edge, so two guards leave a third of the edge.
constexpr double kGuardPart = 1.0 / 3;

/// A guard's sides are at most this fraction of every edge at its tip.
constexpr double kOtherPart = 0.7;

double length(const PeriodicMesh& cells, int c) {
    return (cells.point(cells.next(c)) - cells.point(c)).norm();
}

/// Returns the interior angle at corner c, above 180 degrees for a reflex corner.
double corner_angle(const PeriodicMesh& cells, int c) {
    const Vec2 here = cells.point(c);
    const double angle =
        angle_at({here, cells.point(cells.next(c)), cells.point(cells.previous(c))}, 0);
    return angle < 0 ? angle + 360 : angle;
}

class Guards {
   public:
    Guards(const PeriodicMesh& cells, const GuardOptions& options)
        : cells_(cells),
          per_edge_(options.per_edge),
          radius_(cells.vertices.size(), options.longest),
          guard_at_start_(cells.corner_vertex.size(), false),
          node_(cells.corner_vertex.size(), -1),
          between_(cells.corner_vertex.size(), -1) {
        for (int c = 0; c < cells.n_corners(); ++c) {
            checkpoint_each(c);
            const double angle = corner_angle(cells, c);
            if (angle < kSharpCorner) add_tip({c, angle});
        }
        for (int c = 0; c < cells.n_corners(); ++c) {
            checkpoint_each(c);
            double& radius = radius_[cells.corner_vertex[c]];
            radius = std::min(radius, kOtherPart * length(cells, c));
        }
        for (std::size_t v = 0; v < options.part.size(); ++v) radius_[v] *= options.part[v];
    }

    GuardedCells build() {
        GuardedCells guarded{{.lattice = cells_.lattice,
                              .kind = cells_.kind,
                              .vertices = cells_.vertices,
                              .site = cells_.site},
                             {},
                             {},
                             {}};
        for (int f = 0; f < cells_.n_faces(); ++f) {
            checkpoint_each(f);
            for (int c = cells_.face_begin[f]; c < cells_.face_begin[f + 1]; ++c) {
                add_edge(c, guarded);
            }
            guarded.cells.face_begin.push_back(guarded.cells.n_corners());
        }
        guarded.sharp = tips_;
        for (const SharpCorner& tip : tips_) guarded.tip.push_back(first_corner_[tip.corner]);
        link_faces(guarded.cells);
        return guarded;
    }

   private:
    void add_tip(const SharpCorner& tip) {
        tips_.push_back(tip);
        double& radius = radius_[cells_.corner_vertex[tip.corner]];
        const int before = cells_.previous(tip.corner);
        for (const int c : {tip.corner, before}) {
            radius = std::min(radius, std::min(kGuardPart, 1.0 / per_edge_) * length(cells_, c));
        }
        // Mark the two halfedges that leave the tip along the sides of its face.
        guard_at_start_[tip.corner] = true;
        guard_at_start_[cells_.opposite[before]] = true;
    }

    void add_corner(int vertex, Offset offset, GuardedCells& guarded) const {
        guarded.cells.corner_vertex.push_back(vertex);
        guarded.cells.corner_offset.push_back(offset);
    }

    int add_vertex(const Vec2& point, int tip, GuardedCells& guarded) const {
        guarded.cells.vertices.push_back(point);
        guarded.tip_of_new.push_back(tip);
        return guarded.cells.n_vertices() - 1;
    }

    /// Adds the guard's vertex near corner `end`, an end of the edge that corner c leaves. Both
    /// sides of the edge share the vertex.
    void add_node(int c, int end, GuardedCells& guarded) {
        const int v = cells_.corner_vertex[end];
        const int key = end == c ? c : cells_.opposite[c];
        if (node_[key] < 0) {
            const Vec2 way = cells_.point(end == c ? cells_.next(c) : c) - cells_.point(end);
            node_[key] = add_vertex(cells_.vertices[v] + radius_[v] / way.norm() * way, v, guarded);
        }
        add_corner(node_[key], cells_.corner_offset[end], guarded);
    }

    void add_edge(int c, GuardedCells& guarded) {
        const int next = cells_.next(c);
        const bool at_start = guard_at_start_[c];
        const bool at_end = guard_at_start_[cells_.opposite[c]];
        first_corner_.push_back(guarded.cells.n_corners());
        add_corner(cells_.corner_vertex[c], cells_.corner_offset[c], guarded);
        if (at_start) add_node(c, c, guarded);
        add_between(c, at_start, at_end, guarded);
        if (at_end) add_node(c, next, guarded);
    }

    /// Divides the part of an edge between its guards into equal parts. Both sides of the edge
    /// share the new vertices.
    void add_between(int c, bool at_start, bool at_end, GuardedCells& guarded) {
        const int n = per_edge_ - at_start - at_end - 1;
        if (n <= 0) return;
        const int back = cells_.opposite[c];
        const bool is_first = between_[back] < 0;
        if (is_first) {
            const Vec2 way = cells_.point(cells_.next(c)) - cells_.point(c);
            const double begin = at_start ? radius_[cells_.corner_vertex[c]] / way.norm() : 0;
            const double end =
                at_end ? radius_[cells_.corner_vertex[cells_.next(c)]] / way.norm() : 0;
            between_[c] = guarded.cells.n_vertices();
            for (int k = 1; k <= n; ++k) {
                const double part = begin + (1 - begin - end) * k / (n + 1);
                add_vertex(cells_.vertices[cells_.corner_vertex[c]] + part * way, -1, guarded);
            }
        }
        const Offset offset = cells_.corner_offset[is_first ? c : cells_.next(c)];
        for (int k = 0; k < n; ++k) {
            add_corner(is_first ? between_[c] + k : between_[back] + n - 1 - k, offset, guarded);
        }
    }

    const PeriodicMesh& cells_;
    int per_edge_;
    std::vector<SharpCorner> tips_;
    /// For each vertex, the distance of the vertices of its guards.
    std::vector<double> radius_;
    /// For each halfedge, whether a guard's vertex lies near its start.
    std::vector<char> guard_at_start_;
    /// For each halfedge, that vertex, or -1.
    std::vector<int> node_;
    /// For the first side of each edge, the first vertex between its guards.
    std::vector<int> between_;
    /// For each corner of the old cells, its index in the new cells.
    std::vector<int> first_corner_;
};

}  // namespace

GuardedCells guard_corners(const PeriodicMesh& cells, const GuardOptions& options) {
    return Guards(cells, options).build();
}

}  // namespace pcvt::plane
