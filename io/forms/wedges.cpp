#include "io/forms/wedges.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "mesher/base/checkpoint.hpp"

namespace pcvt {
namespace {

constexpr int kCorners = 3;

/// Where a directed edge belongs: a face and the number of a corner.
using EdgePlaces = std::map<std::pair<int, int>, std::array<int, 2>>;

EdgePlaces edge_places(const plane::Tile& tile) {
    EdgePlaces places;
    for (int f = 0; f < tile.n_faces(); ++f) {
        checkpoint_each(f);
        const auto corners = tile.faces[f];
        for (int k = 0; k < kCorners; ++k) {
            places[{corners[k], corners[(k + 1) % kCorners]}] = {f, k};
        }
    }
    return places;
}

SharedEdge shared_edge(const std::array<int, 2>& one, const std::array<int, 2>& other,
                       bool is_between_cells) {
    return {.faces = {one[0], other[0]},
            .sides = {one[1], other[1]},
            .is_between_cells = is_between_cells};
}

}  // namespace

std::vector<int> WedgeNodes::wedge(std::span<const int> triangle) const {
    std::vector<int> nodes;
    // The corners at the bottom and at the top, then the middles of the edges of both.
    for (std::size_t first = 0; first < triangle.size(); first += kCorners) {
        const auto part = triangle.subspan(first, kCorners);
        nodes.insert(nodes.end(), part.begin(), part.end());
        for (const int v : part) nodes.push_back(at_top(v));
    }
    if (order == 2) {
        for (const int v : triangle.first(kCorners)) nodes.push_back(in_middle(v));
    }
    return nodes;
}

ElementMesh wedge_mesh(const ElementMesh& triangles, int n_corners, double thickness) {
    const bool is_quadratic = triangles.elements.kind == ElementKind::kTriangle6;
    const WedgeNodes layer{triangles.n_nodes(), n_corners, is_quadratic ? 2 : 1};
    const std::vector<double>& p = triangles.periods;
    ElementMesh mesh{.dimension = 3,
                     .periods = {p[0], p[1], 0, p[2], p[3], 0, 0, 0, thickness},
                     .element_site = triangles.element_site};
    for (int node = 0; node < layer.n_nodes(); ++node) {
        const int v = layer.column(node);
        const int representative = triangles.orbit[v];
        const auto& [x, y, z] = triangles.nodes[v];
        const bool is_at_top = layer.is_at_top(node);
        mesh.nodes.push_back({x, y, layer.height(node, thickness)});
        mesh.orbit.push_back(node - v > layer.n_layer ? layer.in_middle(representative)
                                                      : representative);
        mesh.offsets.insert(mesh.offsets.end(), {triangles.offsets[2 * v],
                                                 triangles.offsets[2 * v + 1], is_at_top ? 1 : 0});
    }
    mesh.elements.kind = is_quadratic ? ElementKind::kWedge15 : ElementKind::kWedge6;
    for (int e = 0; e < triangles.elements.size(); ++e) {
        checkpoint_each(e);
        mesh.elements.nodes.add(layer.wedge(triangles.elements.nodes[e]));
    }
    return mesh;
}

std::vector<SharedEdge> shared_edges(const plane::Tile& tile, const TriangleCells& cells) {
    const EdgePlaces places = edge_places(tile);
    std::vector<SharedEdge> edges;
    // Edges inside of the tile have a face on both of their sides.
    for (const auto& [edge, place] : places) {
        if (edge.first > edge.second) continue;
        const auto other = places.find({edge.second, edge.first});
        if (other == places.end()) continue;
        edges.push_back(shared_edge(place, other->second, !cells.same(place[0], other->second[0])));
    }
    for (const plane::EdgePair& pair : tile.edge_pairs) {
        const std::array<int, 2>& one = places.at({pair.v0, pair.v1});
        const std::array<int, 2>& other = places.at({pair.w1, pair.w0});
        const plane::Vec2 image = cells.site_point(one[0]) + tile.lattice.translation(pair.offset);
        const bool is_same = cells.site(one[0]) == cells.site(other[0]) &&
                             cells.same_place(image, cells.site_point(other[0]));
        edges.push_back(shared_edge(one, other, !is_same));
    }
    return edges;
}

}  // namespace pcvt
