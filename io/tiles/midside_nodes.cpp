#include "io/tiles/midside_nodes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

namespace pcvt {
namespace {

constexpr int kCorners = 3;
/// As the proof of a tile compares positions: a representative plus a translation is rounded.
constexpr double kUlps = 4;

[[noreturn]] void throw_bad_file(const RawTile& raw, int line, const std::string& complaint) {
    throw BadFile(raw.name + ":" + std::to_string(line) + ": " + complaint);
}

std::string node_name(const RawTile& raw, int node) {
    return "node " + std::to_string(node + raw.index_base);
}

bool same_edge(const MidsideNode& e, const MidsideNode& f) {
    return e.low == f.low && e.high == f.high;
}

double position_tolerance(const RawTile& raw, Precision precision) {
    double largest = 0;
    for (const Vec2& p : raw.points) largest = std::max(largest, p.cwiseAbs().maxCoeff());
    const double epsilon = precision == Precision::kDouble
                               ? std::numeric_limits<double>::epsilon()
                               : double{std::numeric_limits<float>::epsilon()};
    return kUlps * epsilon * largest;
}

/// Every middle node of every face, by rising ends.
std::vector<MidsideNode> all_middles(const RawTile& raw) {
    std::vector<MidsideNode> middles;
    middles.reserve(raw.corners.size() / 2);
    for (std::size_t f = 0; f < raw.face_lines.size(); ++f) {
        const int* nodes = &raw.corners[raw.face_begin[f]];
        for (int k = 0; k < kCorners; ++k) {
            const auto [low, high] = std::minmax(nodes[k], nodes[(k + 1) % kCorners]);
            middles.push_back({low, high, nodes[kCorners + k], raw.face_lines[f], 1});
        }
    }
    std::stable_sort(middles.begin(), middles.end(),
                     [](const MidsideNode& e, const MidsideNode& f) {
                         return std::tie(e.low, e.high) < std::tie(f.low, f.high);
                     });
    return middles;
}

/// Which nodes are corners; one that is in the middle of an edge as well is refused.
void require_distinct(const RawTile& raw, const std::vector<MidsideNode>& edges) {
    std::vector<bool> taken(raw.points.size(), false);
    for (std::size_t f = 0; f < raw.face_lines.size(); ++f) {
        for (int k = 0; k < kCorners; ++k) taken[raw.corners[raw.face_begin[f] + k]] = true;
    }
    for (const MidsideNode& edge : edges) {
        if (taken[edge.node]) {
            throw_bad_file(
                raw, edge.line,
                node_name(raw, edge.node) +
                    " is in the middle of an edge and has a second place; give each its own");
        }
        taken[edge.node] = true;
    }
}

void require_middle_positions(const RawTile& raw, const std::vector<MidsideNode>& edges,
                              double tolerance) {
    for (const MidsideNode& edge : edges) {
        const Vec2& low = raw.points[edge.low];
        const Vec2 middle = low + (raw.points[edge.high] - low) / 2;
        if ((raw.points[edge.node] - middle).cwiseAbs().maxCoeff() <= tolerance) continue;
        throw_bad_file(
            raw, edge.line,
            node_name(raw, edge.node) + " is not in the middle of its edge; take straight edges");
    }
}

/// Each pair of middle nodes is a translation, each one on the boundary belongs to one pair.
void require_pairs(const RawTile& raw, const std::vector<MidsideNode>& edges,
                   const Lattice& lattice, double tolerance) {
    std::vector<const MidsideNode*> edge_of(raw.points.size(), nullptr);
    for (const MidsideNode& edge : edges) edge_of[edge.node] = &edge;
    std::vector<bool> paired(raw.points.size(), false);
    for (const VertexPair& pair : raw.vertex_pairs) {
        const MidsideNode* edge = edge_of[pair.w];
        if (edge == nullptr && edge_of[pair.v] == nullptr) continue;
        const Vec2 image = raw.points[pair.v] + lattice.translation(pair.offset);
        if (edge == nullptr || edge_of[pair.v] == nullptr ||
            !((raw.points[pair.w] - image).cwiseAbs().maxCoeff() <= tolerance)) {
            throw_bad_file(
                raw, edge == nullptr ? edge_of[pair.v]->line : edge->line,
                node_name(raw, pair.v) + " and " + node_name(raw, pair.w) +
                    " are paired, but are not translates; write the file again with pcvt");
        }
        paired[pair.v] = paired[pair.w] = true;
    }
    for (const MidsideNode& edge : edges) {
        if ((edge.n_faces == 1) == paired[edge.node]) continue;
        throw_bad_file(raw, edge.line,
                       node_name(raw, edge.node) +
                           (edge.n_faces == 1 ? " lies on the boundary, but has no partner"
                                              : " lies inside, but has a partner") +
                           "; write the file again with pcvt");
    }
}

/// Drops the middle nodes and counts the others anew.
void compact(RawTile& raw, const std::vector<MidsideNode>& edges) {
    std::vector<int> place(raw.points.size(), 0);
    for (const MidsideNode& edge : edges) place[edge.node] = -1;
    const bool one_site_a_node = raw.sites.size() == raw.points.size();
    int n = 0;
    for (std::size_t v = 0; v < place.size(); ++v) {
        if (place[v] < 0) continue;
        raw.points[n] = raw.points[v];
        if (one_site_a_node) raw.sites[n] = raw.sites[v];
        place[v] = n++;
    }
    raw.points.resize(n);
    if (one_site_a_node) raw.sites.resize(n);
    std::vector<int> corners;
    for (std::size_t f = 0; f < raw.face_lines.size(); ++f) {
        for (int k = 0; k < kCorners; ++k) {
            corners.push_back(place[raw.corners[raw.face_begin[f] + k]]);
        }
        raw.face_begin[f] = kCorners * static_cast<int>(f);
    }
    raw.face_begin.back() = static_cast<int>(corners.size());
    raw.corners = std::move(corners);
    std::vector<VertexPair> pairs;
    for (const VertexPair& pair : raw.vertex_pairs) {
        if (place[pair.w] >= 0) pairs.push_back({place[pair.v], place[pair.w], pair.offset});
    }
    raw.vertex_pairs = std::move(pairs);
    for (EdgePair& pair : raw.edge_pairs) {
        pair = {place[pair.v0], place[pair.v1], place[pair.w0], place[pair.w1], pair.offset};
    }
}

}  // namespace

std::vector<MidsideNode> file_midside_nodes(const RawTile& raw) {
    std::vector<MidsideNode> edges;
    for (const MidsideNode& middle : all_middles(raw)) {
        if (edges.empty() || !same_edge(edges.back(), middle)) {
            edges.push_back(middle);
        } else if (edges.back().node == middle.node) {
            ++edges.back().n_faces;
        } else {
            throw_bad_file(raw, middle.line,
                           "the edge from " + node_name(raw, middle.low) + " to " +
                               node_name(raw, middle.high) +
                               " has two middle nodes; let its triangles " + "share one");
        }
    }
    require_distinct(raw, edges);
    return edges;
}

void remove_midside_nodes(RawTile& raw, const std::optional<Lattice>& lattice,
                          Precision precision) {
    const std::vector<MidsideNode> edges = file_midside_nodes(raw);
    const double tolerance = position_tolerance(raw, precision);
    require_middle_positions(raw, edges, tolerance);
    const std::optional<Lattice>& stated = raw.lattice ? raw.lattice : lattice;
    if (stated && !raw.vertex_pairs.empty()) require_pairs(raw, edges, *stated, tolerance);
    compact(raw, edges);
    raw.order = 2;
}

}  // namespace pcvt
