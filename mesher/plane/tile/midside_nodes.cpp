#include "mesher/plane/tile/midside_nodes.hpp"

#include <algorithm>
#include <tuple>

#include "mesher/base/cancellable_sort.hpp"
#include "mesher/base/checkpoint.hpp"

namespace pcvt::plane {
namespace {

/// An edge of the tile under the same name from both of its faces.
struct Edge {
    int low;
    int high;
    int corner;
    friend auto operator<=>(const Edge&, const Edge&) = default;
};

Edge edge(int v, int w, int corner) { return {std::min(v, w), std::max(v, w), corner}; }

bool same(const Edge& e, const Edge& f) { return e.low == f.low && e.high == f.high; }

/// Every corner's edge, sorted.
std::vector<Edge> sorted_edges(const Tile& tile) {
    std::vector<Edge> edges;
    edges.reserve(tile.faces.corners.size());
    for (int f = 0; f < tile.n_faces(); ++f) {
        checkpoint_each(f);
        for (int c = tile.faces.begin[f]; c < tile.faces.begin[f + 1]; ++c) {
            const int next = c + 1 == tile.faces.begin[f + 1] ? tile.faces.begin[f] : c + 1;
            edges.push_back(edge(tile.faces.corners[c], tile.faces.corners[next], c));
        }
    }
    cancellable_sort(edges.begin(), edges.end());
    return edges;
}

/// For each corner the first corner on the same edge.
std::vector<int> first_corners(const std::vector<Edge>& edges) {
    std::vector<int> first(edges.size());
    for (std::size_t k = 0; k < edges.size(); ++k) {
        checkpoint_each(k);
        const bool again = k > 0 && same(edges[k], edges[k - 1]);
        first[edges[k].corner] = again ? first[edges[k - 1].corner] : edges[k].corner;
    }
    return first;
}

int node_between(const std::vector<Edge>& edges, const MidsideNodes& nodes, int v, int w) {
    const Edge found = *std::lower_bound(edges.begin(), edges.end(), edge(v, w, 0));
    return nodes.of_corner[found.corner];
}

}  // namespace

MidsideNodes midside_nodes(const Tile& tile) {
    const std::vector<Edge> edges = sorted_edges(tile);
    const std::vector<int> first = first_corners(edges);
    MidsideNodes nodes;
    nodes.of_corner.resize(tile.faces.corners.size());
    for (std::size_t c = 0; c < first.size(); ++c) {
        nodes.of_corner[c] = first[c] == static_cast<int>(c)
                                 ? tile.n_vertices() + static_cast<int>(nodes.points.size())
                                 : nodes.of_corner[first[c]];
        if (first[c] == static_cast<int>(c)) nodes.points.emplace_back(0, 0);
    }
    for (const Edge& e : edges) {
        nodes.points[nodes.of_corner[e.corner] - tile.n_vertices()] =
            tile.points[e.low] + (tile.points[e.high] - tile.points[e.low]) / 2;
    }
    for (const EdgePair& pair : tile.edge_pairs) {
        const int v = node_between(edges, nodes, pair.v0, pair.v1);
        const int w = node_between(edges, nodes, pair.w0, pair.w1);
        nodes.of_edge_pair.push_back({v, w});
        const bool forward = v < w;
        const VertexPair link{std::min(v, w), std::max(v, w), forward ? pair.offset : -pair.offset};
        nodes.pairs.push_back(link);
        nodes.points[link.w - tile.n_vertices()] =
            nodes.points[link.v - tile.n_vertices()] + tile.lattice.translation(link.offset);
    }
    for (const WallEdge& wall : tile.wall_edges) {
        nodes.of_wall_edge.push_back(node_between(edges, nodes, wall.v0, wall.v1));
    }
    cancellable_sort(nodes.pairs.begin(), nodes.pairs.end(),
                     [](const VertexPair& p, const VertexPair& q) {
                         return std::tie(p.w, p.v) < std::tie(q.w, q.v);
                     });
    return nodes;
}

}  // namespace pcvt::plane
