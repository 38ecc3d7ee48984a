#include <algorithm>
#include <string>

#include "mesher/base/disjoint_sets.hpp"
#include "mesher/base/law_violation.hpp"
#include "mesher/plane/proof/validate.hpp"
#include "mesher/plane/proof/vertex_orbits.hpp"

namespace pcvt::plane {
namespace {

using std::to_string;

const char* const kPairs = "of the stored identification";

void require_vertex(int v, const std::string& name, int n_vertices) {
    if (v >= 0 && v < n_vertices) return;
    throw_violation(
        kPairs, name + " names vertex " + to_string(v) + "; there are " + to_string(n_vertices));
}

std::string stated(int v, int w, Offset offset) {
    return "vertex " + to_string(w) + " = vertex " + to_string(v) + " + " + offset_in_words(offset);
}

std::string wall_edge_in_words(const Tile& tile, const WallEdge& edge) {
    return to_string(edge.v0) + " -> " + to_string(edge.v1) + " on " + wall_name(tile, edge.wall);
}

void require_true_pair(const VertexPair& pair, std::size_t index, const VertexOrbits& orbits) {
    const std::string name = "vertex pair " + to_string(index);
    const int n = static_cast<int>(orbits.offset.size());
    require_vertex(pair.v, name, n);
    require_vertex(pair.w, name, n);
    const std::string says = name + " says " + stated(pair.v, pair.w, pair.offset);
    if (orbits.representative[pair.v] != orbits.representative[pair.w]) {
        throw_violation(kPairs, says + "; they are not images of each other");
    }
    const Offset offset = orbits.offset[pair.w] - orbits.offset[pair.v];
    if (offset != pair.offset)
        throw_violation(kPairs, says + "; the offset is " + offset_in_words(offset));
}

/// The edge pair seen from its side with the positive translation, on the first copies of vertices.
EdgePair normal_form(const EdgePair& pair, const TileProof& proof) {
    const auto first = [&](int v) { return proof.first_copy[v]; };
    const EdgePair moved{.v0 = first(pair.v0),
                         .v1 = first(pair.v1),
                         .w0 = first(pair.w0),
                         .w1 = first(pair.w1),
                         .offset = pair.offset};
    return pair.offset >= Offset{} ? moved : moved.reversed();
}

std::string edge_pair_in_words(const EdgePair& pair) {
    return "edge " + edge_in_words(pair.w0, pair.w1) + " = edge " +
           edge_in_words(pair.v0, pair.v1) + " + " + offset_in_words(pair.offset);
}

EdgePair checked_edge_pair(const Tile& tile, const TileProof& proof, std::size_t index) {
    const EdgePair& pair = tile.edge_pairs[index];
    const std::string name = "edge pair " + to_string(index);
    const int n = static_cast<int>(proof.first_copy.size());
    for (const int v : {pair.v0, pair.v1, pair.w0, pair.w1}) require_vertex(v, name, n);
    const EdgePair normal = normal_form(pair, proof);
    if (!std::binary_search(proof.edge_pairs.begin(), proof.edge_pairs.end(), normal)) {
        throw_violation(kPairs, name + " says " + edge_pair_in_words(pair) +
                                    "; no two boundary edges are glued in this way");
    }
    return normal;
}

}  // namespace

void compare_vertex_pairs(const Tile& tile, const TileProof& proof) {
    const VertexOrbits orbits = proven_orbits(proof);
    const int n = static_cast<int>(orbits.offset.size());
    DisjointSets stored(n);
    for (int v = 0; v < n; ++v) stored.unite(v, proof.first_copy[v]);
    for (std::size_t k = 0; k < tile.vertex_pairs.size(); ++k) {
        require_true_pair(tile.vertex_pairs[k], k, orbits);
        stored.unite(tile.vertex_pairs[k].v, tile.vertex_pairs[k].w);
    }
    for (const VertexPair& pair : proof.vertex_pairs) {
        if (stored.find(pair.v) == stored.find(pair.w)) continue;
        throw_violation(kPairs, "it does not follow from the stored vertex pairs that " +
                                    stated(pair.v, pair.w, pair.offset));
    }
}

void compare_edge_pairs(const Tile& tile, const TileProof& proof) {
    std::vector<EdgePair> stored;
    for (std::size_t k = 0; k < tile.edge_pairs.size(); ++k) {
        stored.push_back(checked_edge_pair(tile, proof, k));
    }
    std::sort(stored.begin(), stored.end());
    for (const EdgePair& pair : proof.edge_pairs) {
        if (std::binary_search(stored.begin(), stored.end(), pair)) continue;
        throw_violation(kPairs, "the stored edge pairs lack " + edge_pair_in_words(pair));
    }
}

void compare_wall_edges(const Tile& tile, const TileProof& proof) {
    const int n = static_cast<int>(proof.first_copy.size());
    std::vector<WallEdge> stored;
    for (std::size_t k = 0; k < tile.wall_edges.size(); ++k) {
        const auto [wall, v0, v1] = tile.wall_edges[k];
        const std::string name = "wall edge " + to_string(k);
        for (const int v : {v0, v1}) require_vertex(v, name, n);
        stored.push_back({wall, proof.first_copy[v0], proof.first_copy[v1]});
        // Single precision may join the ends of an edge.
        if (stored.back().v0 == stored.back().v1) continue;
        if (std::binary_search(proof.wall_edges.begin(), proof.wall_edges.end(), stored.back())) {
            continue;
        }
        throw_violation(kPairs, name + " says " + wall_edge_in_words(tile, tile.wall_edges[k]) +
                                    (wall.is_hole() ? "; the boundary of no hole runs there"
                                                    : "; no edge of a face lies there"));
    }
    std::sort(stored.begin(), stored.end());
    for (const WallEdge& edge : proof.wall_edges) {
        if (std::binary_search(stored.begin(), stored.end(), edge)) continue;
        throw_violation(kPairs, "the stored edges on walls lack " + wall_edge_in_words(tile, edge));
    }
}

}  // namespace pcvt::plane
