#include "mesher/space/grains/shared_moves.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <tuple>

#include "mesher/space/grains/cell_filling.hpp"
#include "mesher/space/grains/face_flips.hpp"
#include "mesher/space/grains/star_shape.hpp"

namespace pcvt::space {
namespace {

constexpr double kSharedProbeGain = 1e-9;
constexpr double kGain = 1e-6;
/// Steps of the search over the shortest edge at the node.
constexpr double kFirstSharedStep = 0.25;
constexpr double kLastSharedStep = 0.02;

/// Distributes items to groups, so that no two of a group have a cell in common: each item in its
/// turn to the first group without its cells.
std::vector<std::vector<int>> independent_groups(const std::vector<std::vector<int>>& cells_of,
                                                 int n_cells) {
    std::vector<std::vector<int>> groups;
    // For each cell the groups that it is in.
    std::vector<std::vector<char>> taken(n_cells);
    for (std::size_t item = 0; item < cells_of.size(); ++item) {
        const std::vector<int>& cells = cells_of[item];
        std::size_t group = 0;
        const auto is_taken = [&](int c) {
            return group < taken[c].size() && taken[c][group] != 0;
        };
        while (std::any_of(cells.begin(), cells.end(), is_taken)) ++group;
        if (group == groups.size()) groups.emplace_back();
        groups[group].push_back(static_cast<int>(item));
        for (const int c : cells) {
            if (taken[c].size() <= group) taken[c].resize(group + 1, 0);
            taken[c][group] = 1;
        }
    }
    return groups;
}

/// Moves of nodes, each in all cells that have it.
class NodeMoves {
   public:
    NodeMoves(const CellComplex& complex, GrainSurface& surface, std::vector<CellHull>& hulls,
              std::vector<CellTetrahedra>& cells)
        : complex_(complex), surface_(surface), hulls_(hulls), cells_(cells) {}

    /// @param ways  unit vectors along which the node may move.
    void move(int node, std::span<const NodeUse> uses, std::span<const Vec3> ways) {
        const bool has_failed = std::all_of(uses.begin(), uses.end(), [&](const NodeUse& use) {
            return cells_[use.cell].has_failed(CellTetrahedra::kMove, use.vertex);
        });
        if (has_failed) return;
        collect_stars(uses);
        const double start = around_[0].quality;
        if (start > kTargetSine) return;
        shape_.clear();
        for (const Around& t : around_) shape_.add(cells_[t.cell], t.tetrahedron, t.vertex);
        double best = start;
        Vec3 way = Vec3::Zero();
        const double shortest = shortest_edge();
        for (double step = kFirstSharedStep; step > kLastSharedStep; step /= 2) {
            for (const Vec3& direction : ways) {
                const Vec3 probe = way + step * shortest * direction;
                const double worst = shape_.least_quality(probe, best);
                if (worst <= best + kSharedProbeGain) continue;
                best = worst;
                way = probe;
            }
        }
        if (best > start + kGain) {
            const Vec3 from = surface_.nodes[node].position;
            place(node, from + way, uses);
            if (worst_placed() > start) return;
            // Two images of the node are corners of one tetrahedron, which has another shape.
            place(node, from, uses);
        }
        for (const NodeUse& use : uses) {
            cells_[use.cell].note_failure(CellTetrahedra::kMove, use.vertex);
        }
    }

   private:
    /// A tetrahedron round an image of a node.
    struct Around {
        double quality;
        int cell;
        int tetrahedron;
        int vertex;
    };

    void collect_stars(std::span<const NodeUse> uses) {
        around_.clear();
        for (const NodeUse& use : uses) {
            const CellTetrahedra& cell = cells_[use.cell];
            cell.find_star(use.vertex, star_);
            for (const int t : star_) around_.push_back({cell.quality(t), use.cell, t, use.vertex});
        }
        // The worst come first, since most probes fail there.
        std::sort(around_.begin(), around_.end(), [](const Around& s, const Around& t) {
            return std::tie(s.quality, s.cell, s.tetrahedron) <
                   std::tie(t.quality, t.cell, t.tetrahedron);
        });
    }

    double worst_placed() const {
        double worst = kUnlimited;
        for (const Around& t : around_) {
            worst = std::min(worst, cells_[t.cell].quality(t.tetrahedron));
        }
        return worst;
    }

    double shortest_edge() const {
        double shortest = kUnlimited;
        for (const Around& t : around_) {
            const CellTetrahedra& cell = cells_[t.cell];
            for (const int v : cell.corners(t.tetrahedron)) {
                if (v == t.vertex) continue;
                shortest =
                    std::min(shortest, squared_distance(cell.point(v), cell.point(t.vertex)));
            }
        }
        return std::sqrt(shortest);
    }

    void place(int node, const Vec3& at, std::span<const NodeUse> uses) {
        surface_.nodes[node].position = at;
        for (const NodeUse& use : uses) {
            CellHull& hull = hulls_[use.cell];
            hull.points[use.vertex] =
                at + complex_.reduced.translation(hull.images[use.vertex].offset);
            cells_[use.cell].set_point(use.vertex, hull.points[use.vertex]);
        }
        for (const Around& t : around_) cells_[t.cell].update_quality(std::array{t.tetrahedron});
    }

    const CellComplex& complex_;
    GrainSurface& surface_;
    std::vector<CellHull>& hulls_;
    std::vector<CellTetrahedra>& cells_;
    std::vector<Around> around_;
    std::vector<int> star_;
    StarShape shape_;
};

std::array<Vec3, 6> ways_in(const FacePlane& plane) {
    const double root = 0.8660254037844386;
    const Vec3 left = 0.5 * plane.x + root * plane.y;
    const Vec3 right = 0.5 * plane.x - root * plane.y;
    return {plane.x, left, -right, -plane.x, -left, right};
}

std::array<Vec3, 2> ways_along(const CellComplex& complex, const CellEdge& edge) {
    const Vec3 along = unit_vector(complex.position(edge.to) - complex.position(edge.from));
    return {along, -along};
}

}  // namespace

SharedMoves::SharedMoves(const CellComplex& complex, GrainSurface& surface,
                         std::vector<CellHull>& hulls, std::vector<CellTetrahedra>& cells,
                         Workers& workers)
    : complex_(complex),
      surface_(surface),
      hulls_(hulls),
      cells_(cells),
      workers_(workers),
      uses_(surface.nodes.size()),
      face_nodes_(complex.faces.size()) {
    for (int c = 0; c < static_cast<int>(hulls.size()); ++c) {
        const std::vector<NodeImage>& images = hulls[c].images;
        for (int v = 0; v < static_cast<int>(images.size()); ++v) {
            uses_[images[v].vertex].push_back({c, v});
        }
    }
    for (int node = 0; node < static_cast<int>(surface.nodes.size()); ++node) {
        const SurfaceNode& at = surface.nodes[node];
        if (at.dimension == 2) face_nodes_[at.carrier].push_back(node);
    }
    std::vector<std::vector<int>> cells_of;
    for (const CellFace& face : complex.faces) cells_of.push_back({face.cell, face.neighbour});
    faces_ = independent_groups(cells_of, complex.n_cells);
    cells_of.clear();
    for (const CellEdge& edge : surface.edges.edges) {
        std::vector<int>& its = cells_of.emplace_back();
        for (const int f : edge.faces) {
            its.insert(its.end(), {complex.faces[f].cell, complex.faces[f].neighbour});
        }
    }
    edges_ = independent_groups(cells_of, complex.n_cells);
}

template <class Task>
void SharedMoves::for_each_of(const Groups& groups, const Task& task) {
    for (const std::vector<int>& group : groups) {
        workers_.for_each(static_cast<int>(group.size()), [&](int k) { task(group[k]); });
    }
}

void SharedMoves::flip_edges() {
    for_each_of(faces_, [&](int f) { flip_face_edges(complex_, surface_, hulls_, cells_, f); });
}

void SharedMoves::move_nodes() {
    for_each_of(edges_, [&](int e) {
        NodeMoves moves(complex_, surface_, hulls_, cells_);
        const std::array<Vec3, 2> ways = ways_along(complex_, surface_.edges.edges[e]);
        for (const int node : surface_.edge_nodes[e]) moves.move(node, uses_[node], ways);
    });
    for_each_of(faces_, [&](int f) {
        NodeMoves moves(complex_, surface_, hulls_, cells_);
        const std::array<Vec3, 6> ways = ways_in(face_plane(complex_, f));
        for (const int node : face_nodes_[f]) moves.move(node, uses_[node], ways);
    });
}

}  // namespace pcvt::space
