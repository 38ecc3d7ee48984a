#include "io/forms/midside_nodes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <tuple>
#include <utility>

#include "mesher/base/cancellable_sort.hpp"
#include "mesher/base/checkpoint.hpp"

namespace pcvt {
namespace {

constexpr int kCorners = 3;
/// As the proof of a tile compares positions: a representative plus a translation is rounded.
constexpr double kMidsideUlps = 4;

[[noreturn]] void throw_bad_file(const FileTileBuilder& file, int line,
                                 const std::string& complaint) {
    throw BadFile(file.name + ":" + std::to_string(line) + ": " + complaint);
}

std::string node_name(const FileTileBuilder& file, int node) {
    return "node " + std::to_string(node + file.index_base);
}

bool same_edge(const MidsideNode& e, const MidsideNode& f) {
    return e.low == f.low && e.high == f.high;
}

double position_tolerance(const FileTileBuilder& file, plane::Precision precision) {
    double largest = 0;
    for (const plane::Vec2& p : file.points) largest = std::max(largest, p.cwiseAbs().maxCoeff());
    const double epsilon = precision == plane::Precision::kDouble
                               ? std::numeric_limits<double>::epsilon()
                               : double{std::numeric_limits<float>::epsilon()};
    return kMidsideUlps * epsilon * largest;
}

/// Every middle node of every face, by rising ends.
std::vector<MidsideNode> all_middles(const FileTileBuilder& file) {
    std::vector<MidsideNode> middles;
    middles.reserve(file.faces.corners.size() / 2);
    for (int f = 0; f < file.faces.n_faces(); ++f) {
        checkpoint_each(f);
        const auto nodes = file.faces[f];
        for (int k = 0; k < kCorners; ++k) {
            const auto [low, high] = std::minmax(nodes[k], nodes[(k + 1) % kCorners]);
            middles.push_back({.low = low,
                               .high = high,
                               .node = nodes[kCorners + k],
                               .line = file.face_lines[f],
                               .n_faces = 1});
        }
    }
    cancellable_stable_sort(middles.begin(), middles.end(),
                            [](const MidsideNode& e, const MidsideNode& f) {
                                return std::tie(e.low, e.high) < std::tie(f.low, f.high);
                            });
    return middles;
}

/// Which nodes are corners; one that is in the middle of an edge as well is refused.
void require_distinct(const FileTileBuilder& file, const std::vector<MidsideNode>& edges) {
    std::vector<bool> taken(file.points.size(), false);
    for (int f = 0; f < file.faces.n_faces(); ++f) {
        checkpoint_each(f);
        for (const int v : file.faces[f].first(kCorners)) taken[v] = true;
    }
    for (const MidsideNode& edge : edges) {
        if (taken[edge.node]) {
            throw_bad_file(
                file, edge.line,
                node_name(file, edge.node) +
                    " is in the middle of an edge and has a second place; give each its own");
        }
        taken[edge.node] = true;
    }
}

void require_middle_positions(const FileTileBuilder& file, const std::vector<MidsideNode>& edges,
                              double tolerance) {
    for (const MidsideNode& edge : edges) {
        const plane::Vec2& low = file.points[edge.low];
        const plane::Vec2 middle = low + (file.points[edge.high] - low) / 2;
        if ((file.points[edge.node] - middle).cwiseAbs().maxCoeff() <= tolerance) continue;
        throw_bad_file(
            file, edge.line,
            node_name(file, edge.node) + " is not in the middle of its edge; take straight edges");
    }
}

/// Whether both ends of an edge lie on one wall.
bool is_on_wall(const FileTileBuilder& file, const MidsideNode& edge, const plane::Lattice& lattice,
                double tolerance) {
    const auto is_on = [&](const WallSideRow& row) {
        if (!has_walls_across(file.notes.walls, row.axis)) return false;
        const double line = wall_line(row, lattice);
        return std::abs(file.points[edge.low][row.axis] - line) <= tolerance &&
               std::abs(file.points[edge.high][row.axis] - line) <= tolerance;
    };
    return std::any_of(kWallSides.begin(), kWallSides.end(), is_on);
}

/// The ends of the edges of holes, the lower one first; corners precede other nodes in files of
/// tiles with holes.
std::set<std::pair<int, int>> hole_edges(const FileTileBuilder& file) {
    std::set<std::pair<int, int>> edges;
    for (const plane::WallEdge& edge : file.notes.hole_edges)
        edges.insert(std::minmax(edge.v0, edge.v1));
    return edges;
}

/// Each pair of middle nodes is a translation, each one on the seam belongs to one pair.
void require_pairs(const FileTileBuilder& file, const std::vector<MidsideNode>& edges,
                   const plane::Lattice& lattice, double tolerance) {
    std::vector<const MidsideNode*> edge_of(file.points.size(), nullptr);
    for (const MidsideNode& edge : edges) edge_of[edge.node] = &edge;
    std::vector<bool> paired(file.points.size(), false);
    for (const plane::VertexPair& pair : file.vertex_pairs) {
        const MidsideNode* edge = edge_of[pair.w];
        if (edge == nullptr && edge_of[pair.v] == nullptr) continue;
        const plane::Vec2 image = file.points[pair.v] + lattice.translation(pair.offset);
        if (edge == nullptr || edge_of[pair.v] == nullptr ||
            !((file.points[pair.w] - image).cwiseAbs().maxCoeff() <= tolerance)) {
            throw_bad_file(
                file, edge == nullptr ? edge_of[pair.v]->line : edge->line,
                node_name(file, pair.v) + " and " + node_name(file, pair.w) +
                    " are paired, but are not translates; write the file again with pcvt");
        }
        paired[pair.v] = paired[pair.w] = true;
    }
    const std::set<std::pair<int, int>> at_holes = hole_edges(file);
    for (const MidsideNode& edge : edges) {
        const bool is_wall = edge.n_faces == 1 && (is_on_wall(file, edge, lattice, tolerance) ||
                                                   at_holes.contains({edge.low, edge.high}));
        if ((edge.n_faces == 1 && !is_wall) == paired[edge.node]) continue;
        throw_bad_file(file, edge.line,
                       node_name(file, edge.node) +
                           (is_wall             ? " lies on a wall, but has a partner"
                            : edge.n_faces == 1 ? " lies on the boundary, but has no partner"
                                                : " lies inside, but has a partner") +
                           "; write the file again with pcvt");
    }
}

/// Drops the mid-side nodes and renumbers the others.
void compact(FileTileBuilder& file, const std::vector<MidsideNode>& edges) {
    std::vector<int> place(file.points.size(), 0);
    for (const MidsideNode& edge : edges) place[edge.node] = -1;
    const bool one_site_a_node = file.sites.size() == file.points.size();
    int n = 0;
    for (std::size_t v = 0; v < place.size(); ++v) {
        if (place[v] < 0) continue;
        file.points[n] = file.points[v];
        if (one_site_a_node) file.sites[n] = file.sites[v];
        place[v] = n++;
    }
    file.points.resize(n);
    if (one_site_a_node) file.sites.resize(n);
    Faces triangles;
    for (int f = 0; f < file.faces.n_faces(); ++f) {
        checkpoint_each(f);
        for (const int v : file.faces[f].first(kCorners)) triangles.corners.push_back(place[v]);
        triangles.close();
    }
    file.faces = std::move(triangles);
    std::vector<plane::VertexPair> pairs;
    for (const plane::VertexPair& pair : file.vertex_pairs) {
        if (place[pair.w] >= 0) pairs.push_back({place[pair.v], place[pair.w], pair.offset});
    }
    file.vertex_pairs = std::move(pairs);
    for (plane::EdgePair& pair : file.edge_pairs) {
        pair = {.v0 = place[pair.v0],
                .v1 = place[pair.v1],
                .w0 = place[pair.w0],
                .w1 = place[pair.w1],
                .offset = pair.offset};
    }
}

}  // namespace

std::vector<MidsideNode> file_midside_nodes(const FileTileBuilder& file) {
    std::vector<MidsideNode> edges;
    for (const MidsideNode& middle : all_middles(file)) {
        if (edges.empty() || !same_edge(edges.back(), middle)) {
            edges.push_back(middle);
        } else if (edges.back().node == middle.node) {
            ++edges.back().n_faces;
        } else {
            throw_bad_file(file, middle.line,
                           "the edge from " + node_name(file, middle.low) + " to " +
                               node_name(file, middle.high) +
                               " has two middle nodes; let its triangles " + "share one");
        }
    }
    require_distinct(file, edges);
    return edges;
}

void remove_midside_nodes(FileTileBuilder& file, const std::optional<plane::Lattice>& lattice,
                          plane::Precision precision) {
    const std::vector<MidsideNode> edges = file_midside_nodes(file);
    const double tolerance = position_tolerance(file, precision);
    require_middle_positions(file, edges, tolerance);
    const std::optional<plane::Lattice>& stated = file.lattice ? file.lattice : lattice;
    if (stated && !file.vertex_pairs.empty()) require_pairs(file, edges, *stated, tolerance);
    compact(file, edges);
    file.order = 2;
}

}  // namespace pcvt
