#include "mesher/space/mesh/short_edges.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "mesher/base/checkpoint.hpp"
#include "mesher/base/disjoint_sets.hpp"
#include "mesher/space/mesh/shrinking_complex.hpp"

namespace pcvt::space {
namespace {

/// The longest edges that are removed in groups, a part of h.
constexpr double kGrouped = 1e-3;

double grouped(const ShrinkingComplex& complex) {
    return std::min(complex.shortest(), kGrouped * complex.spacing());
}

/// Removes those of some edges that are still short.
/// @param place  returns the point to which an edge may shrink, if there is any.
/// @returns whether it has removed an edge.
template <class Place>
bool remove_those(const std::vector<ShortEdge>& edges, const Place& place,
                  ShrinkingComplex& complex) {
    bool any = false;
    long n_seen = 0;
    for (const ShortEdge& edge : edges) {
        checkpoint_each(n_seen++, 64);
        if (!complex.is_short(edge)) continue;
        const std::optional<Vec3> end = place(edge);
        if (!end) continue;
        complex.remove(edge, *end);
        any = true;
    }
    return any;
}

/// Removes short edges one by one until none may be removed.
void remove_edges(ShrinkRule rule, ShrinkingComplex& complex) {
    const auto place = [&](const ShortEdge& edge) {
        return rule == ShrinkRule::kMiddle ? complex.middle_of(edge) : complex.widest_of(edge);
    };
    while (remove_those(complex.edges_below(complex.shortest()), place, complex)) {
    }
}

/// Unites the ends of the short edges of a face that would vanish without them.
void unite_ends(const ShrinkingComplex& complex, int face, DisjointSets& sets) {
    const std::size_t n = complex.corners_of(face).size();
    std::vector<int> ends;
    for (std::size_t k = 0; k < n; ++k) {
        const ShortEdge edge = complex.edge_of(face, k);
        if (edge.length < grouped(complex)) ends.push_back(edge.from);
    }
    if (ends.size() + 3 <= n) return;
    for (const int end : ends) sets.unite(ends.front(), end);
}

/// The ends of edges, ascending, in groups that share a vertex, or a face that vanishes with its
/// edges.
std::vector<std::vector<int>> groups_of(const ShrinkingComplex& complex) {
    const std::vector<ShortEdge> edges = complex.edges_below(grouped(complex));
    DisjointSets sets(complex.n_vertices());
    for (const ShortEdge& edge : edges) sets.unite(edge.from, edge.to.vertex);
    for (int f = 0; f < complex.n_faces(); ++f) unite_ends(complex, f, sets);
    std::map<int, std::vector<int>> groups;
    for (const ShortEdge& edge : edges) {
        std::vector<int>& group = groups[sets.find(edge.from)];
        group.insert(group.end(), {edge.from, edge.to.vertex});
    }
    std::vector<std::vector<int>> all;
    for (auto& [first, group] : groups) {
        std::sort(group.begin(), group.end());
        group.erase(std::unique(group.begin(), group.end()), group.end());
        all.push_back(std::move(group));
    }
    return all;
}

/// Removes the edges of a group unless that leaves a sharp corner.
void remove_group(const std::vector<int>& vertices, ShrinkingComplex& complex) {
    const std::vector<int> faces = complex.faces_at(vertices);
    const ShrinkingComplex::State before = complex.state_of(vertices, faces);
    const double least = std::min(kSharpCorner, complex.sharpest_of(faces)) - kCornerGain;
    const auto is_in = [&](int v) {
        return std::binary_search(vertices.begin(), vertices.end(), v);
    };
    const auto middle = [&](const ShortEdge& edge) {
        const bool belongs = is_in(edge.from) && is_in(edge.to.vertex);
        return belongs ? complex.middle_of(edge) : std::nullopt;
    };
    while (remove_those(complex.edges_below(grouped(complex), faces), middle, complex)) {
    }
    if (!(complex.sharpest_of(faces) > least)) complex.restore(before);
}

/// Removes groups of edges of which one alone would make a sharp corner: a tiny face loses one
/// edge after the other, and a long narrow one those at both of its ends.
/// @param left  vertices of edges that remain without this: other groups are not removed.
/// @returns whether there are groups of more than one edge.
bool remove_groups(const std::vector<char>& left, ShrinkingComplex& complex) {
    bool any = false;
    for (const std::vector<int>& group : groups_of(complex)) {
        checkpoint();
        const auto is_left = [&](int v) { return left[v] != 0; };
        if (group.size() < 3 || std::none_of(group.begin(), group.end(), is_left)) continue;
        remove_group(group, complex);
        any = true;
    }
    return any;
}

}  // namespace

CellComplex without_short_edges(CellComplex complex, double shortest, ShrinkRule rule) {
    if (shortest == 0) return complex;
    ShrinkingComplex one_by_one(complex, shortest);
    remove_edges(rule, one_by_one);
    std::vector<char> left(complex.vertices.size(), 0);
    if (rule == ShrinkRule::kWideCorners) {
        for (const ShortEdge& edge : one_by_one.edges_below(grouped(one_by_one))) {
            left[edge.from] = left[edge.to.vertex] = 1;
        }
    }
    if (std::find(left.begin(), left.end(), 1) == left.end()) return one_by_one.result();
    // Begin again with the groups of which some edges are left.
    ShrinkingComplex in_groups(complex, shortest);
    if (!remove_groups(left, in_groups)) return one_by_one.result();
    remove_edges(rule, in_groups);
    return in_groups.result();
}

}  // namespace pcvt::space
