#include "io/forms/cell_entities.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>

#include "io/forms/seam_segments.hpp"
#include "io/forms/triangle_cells.hpp"
#include "mesher/base/bucket_sort.hpp"
#include "mesher/base/checkpoint.hpp"

namespace pcvt {
namespace {

/// An edge between two cells, in the direction of the face on its left.
struct CellEdge {
    std::array<int, 2> ends;
    std::array<int, 2> faces;
    /// The node in its middle; -1 for order 1.
    int middle;
};

/// One side of an edge, under the same name from both of its faces.
struct NamedSide {
    int low;
    int high;
    int corner;
    friend auto operator<=>(const NamedSide&, const NamedSide&) = default;
};

class EntityFinder {
   public:
    EntityFinder(const plane::Tile& tile, const SolverNodes& nodes)
        : tile_(tile), nodes_(nodes), cells_(tile), segments_(seam_segments(tile, nodes.middles)) {}

    CellEntities find() {
        make_surfaces();
        find_cell_edges();
        choose_points();
        make_seam_curves();
        make_cell_curves();
        link_curves();
        share_out_nodes();
        return std::move(entities_);
    }

   private:
    int n_vertices() const { return tile_.n_vertices(); }

    void make_surfaces() {
        std::vector<SiteId> sites = cells_.sites();
        std::sort(sites.begin(), sites.end());
        sites.erase(std::unique(sites.begin(), sites.end()), sites.end());
        for (const SiteId site : sites) entities_.surfaces.push_back({site});
        for (int f = 0; f < tile_.n_faces(); ++f) {
            checkpoint_each(f);
            const auto found = std::lower_bound(sites.begin(), sites.end(), cells_.site(f));
            surface_of_.push_back(static_cast<int>(found - sites.begin()));
            entities_.surfaces[surface_of_.back()].triangles.push_back(f);
        }
    }

    /// For each vertex, whether triangles of different cells meet there.
    std::vector<bool> contacts() const {
        std::vector<int> first(tile_.points.size(), -1);
        std::vector<bool> found(tile_.points.size(), false);
        for (int f = 0; f < tile_.n_faces(); ++f) {
            checkpoint_each(f);
            for (const int v : tile_.faces[f]) {
                if (first[v] < 0) first[v] = f;
                if (!cells_.same(first[v], f)) found[v] = true;
            }
        }
        return found;
    }

    int next(int corner) const { return corner % 3 == 2 ? corner - 2 : corner + 1; }

    void find_cell_edges() {
        const std::vector<bool> contact = contacts();
        const std::vector<int>& vertex = tile_.faces.corners;
        std::vector<NamedSide> sides;
        for (int c = 0; c < static_cast<int>(vertex.size()); ++c) {
            const auto [low, high] = std::minmax({vertex[c], vertex[next(c)]});
            if (contact[low] && contact[high]) sides.push_back({low, high, c});
        }
        bucket_sort(sides, n_vertices(), [](const NamedSide& side) { return side.low; });
        for (std::size_t k = 1; k < sides.size(); ++k) {
            const auto& [low, high, d] = sides[k];
            const int c = sides[k - 1].corner;
            if (low != sides[k - 1].low || high != sides[k - 1].high) continue;
            if (cells_.same(c / 3, d / 3)) continue;
            const int middle = nodes_.middles.of_corner.empty() ? -1 : nodes_.middles.of_corner[c];
            edges_.push_back({{vertex[c], vertex[next(c)]}, {c / 3, d / 3}, middle});
        }
        list_edges_by_vertex();
    }

    void list_edges_by_vertex() {
        edges_begin_.assign(static_cast<std::size_t>(n_vertices()) + 1, 0);
        for (const CellEdge& edge : edges_) {
            for (const int v : edge.ends) ++edges_begin_[v + 1];
        }
        std::partial_sum(edges_begin_.begin(), edges_begin_.end(), edges_begin_.begin());
        edges_at_.resize(2 * edges_.size());
        std::vector<int> place(edges_begin_.begin(), edges_begin_.end() - 1);
        for (std::size_t e = 0; e < edges_.size(); ++e) {
            for (const int v : edges_[e].ends) edges_at_[place[v]++] = static_cast<int>(e);
        }
    }

    int n_edges_at(int v) const { return edges_begin_[v + 1] - edges_begin_[v]; }

    /// A point lies wherever more than two edges of curves meet or curves of two kinds meet.
    void choose_points() {
        is_point_.assign(tile_.points.size(), false);
        for (int v = 0; v < n_vertices(); ++v) is_point_[v] = n_edges_at(v) > 2;
        for (const SeamSegment& segment : segments_) {
            is_point_[segment.vertices.front()] = true;
            for (const int v : segment.vertices) {
                if (n_edges_at(v) > 0) is_point_[v] = true;
            }
        }
        // The images of a point are points.
        for (const plane::VertexPair& pair : tile_.vertex_pairs) {
            if (is_point_[pair.w]) is_point_[pair.v] = true;
        }
        for (const plane::VertexPair& pair : tile_.vertex_pairs)
            is_point_[pair.w] = is_point_[pair.v];
    }

    using Ends = std::array<int, 2>;

    /// The face on the left of each boundary edge, by the ends of the edge.
    std::map<Ends, int> boundary_faces() const {
        std::map<Ends, int> face;
        for (const SeamSegment& segment : segments_) {
            for (std::size_t k = 0; k + 1 < segment.vertices.size(); ++k) {
                face[{segment.vertices[k], segment.vertices[k + 1]}] = -1;
            }
        }
        const std::vector<int>& vertex = tile_.faces.corners;
        for (int c = 0; c < static_cast<int>(vertex.size()); ++c) {
            const auto found = face.find({vertex[c], vertex[next(c)]});
            if (found != face.end()) found->second = c / 3;
        }
        return face;
    }

    void make_seam_curves() {
        const std::map<Ends, int> face = boundary_faces();
        std::vector<int> begin;
        for (const SeamSegment& segment : segments_) {
            begin.push_back(n_curves());
            for (std::size_t k = 0; k + 1 < segment.vertices.size(); ++k) {
                const int v = segment.vertices[k];
                if (is_point_[v]) {
                    const int left = face.at({v, segment.vertices[k + 1]});
                    entities_.curves.push_back({.vertices = {v},
                                                .left = surface_of_[left],
                                                .offset = segment.offset,
                                                .wall = segment.wall});
                }
                CellCurve& curve = entities_.curves.back();
                curve.vertices.push_back(segment.vertices[k + 1]);
                if (!segment.middles.empty()) curve.middles.push_back(segment.middles[k]);
            }
        }
        begin.push_back(n_curves());
        // A segment and its partner have the same points, in opposite order.
        for (std::size_t s = 0; s < segments_.size(); ++s) {
            if (segments_[s].wall) continue;
            for (int k = begin[s]; k < begin[s + 1]; ++k) {
                entities_.curves[k].partner = begin[segments_[s].partner + 1] - 1 - (k - begin[s]);
            }
        }
    }

    int n_curves() const { return static_cast<int>(entities_.curves.size()); }

    /// Appends the chain of edges from `v`, along the edge `e`, to the next point.
    void walk(int v, int e) {
        const bool forward = edges_[e].ends[0] == v;
        entities_.curves.push_back({{v},
                                    {},
                                    surface_of_[edges_[e].faces[forward ? 0 : 1]],
                                    surface_of_[edges_[e].faces[forward ? 1 : 0]]});
        CellCurve& curve = entities_.curves.back();
        while (!walked_[e]) {
            walked_[e] = true;
            v = edges_[e].ends[edges_[e].ends[0] == v ? 1 : 0];
            curve.vertices.push_back(v);
            if (edges_[e].middle >= 0) curve.middles.push_back(edges_[e].middle);
            if (is_point_[v]) return;
            // Two edges meet here; the other one continues the chain.
            const int first = edges_at_[edges_begin_[v]];
            e = first == e ? edges_at_[edges_begin_[v] + 1] : first;
        }
    }

    void make_cell_curves() {
        walked_.assign(edges_.size(), false);
        const auto walk_from = [this](int v) {
            for (int k = edges_begin_[v]; k < edges_begin_[v + 1]; ++k) {
                if (!walked_[edges_at_[k]]) walk(v, edges_at_[k]);
            }
        };
        for (int v = 0; v < n_vertices(); ++v) {
            checkpoint_each(v);
            if (is_point_[v]) walk_from(v);
        }
        // Closed curves have no point yet.
        for (const CellEdge& edge : edges_) {
            if (walked_[&edge - edges_.data()]) continue;
            is_point_[edge.ends[0]] = true;
            walk_from(edge.ends[0]);
        }
    }

    void link_curves() {
        for (int k = 0; k < n_curves(); ++k) {
            const CellCurve& curve = entities_.curves[k];
            entities_.surfaces[curve.left].left_of.push_back(k);
            if (!curve.bounds_tile()) entities_.surfaces[curve.right].right_of.push_back(k);
        }
    }

    /// Gives each surface the nodes that lie on no curve.
    void share_out_nodes() {
        std::vector<bool> taken(nodes_.points.size(), false);
        for (const CellCurve& curve : entities_.curves) {
            for (const int v : curve.vertices) taken[v] = true;
            for (const int v : curve.middles) taken[v] = true;
        }
        for (CellSurface& surface : entities_.surfaces) {
            for (const int f : surface.triangles) {
                for (const int v : element_nodes(tile_, nodes_, f)) {
                    if (!taken[v]) surface.nodes.push_back(v);
                    taken[v] = true;
                }
            }
            std::sort(surface.nodes.begin(), surface.nodes.end());
        }
        for (int v = 0; v < n_vertices(); ++v) {
            checkpoint_each(v);
            if (is_point_[v]) entities_.points.push_back(v);
        }
    }

    const plane::Tile& tile_;
    const SolverNodes& nodes_;
    const TriangleCells cells_;
    const std::vector<SeamSegment> segments_;
    CellEntities entities_;
    /// Index of the surface of each triangle.
    std::vector<int> surface_of_;
    /// The edges between cells; vertex v has edges_at_[edges_begin_[v]] ... of them.
    std::vector<CellEdge> edges_;
    std::vector<int> edges_begin_;
    std::vector<int> edges_at_;
    std::vector<bool> is_point_;
    std::vector<bool> walked_;
};

}  // namespace

CellEntities cell_entities(const plane::Tile& tile, const SolverNodes& nodes) {
    return EntityFinder(tile, nodes).find();
}

}  // namespace pcvt
