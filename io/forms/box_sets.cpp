#include "io/forms/box_sets.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>
#include <span>
#include <string_view>
#include <utility>

#include "mesher/cells/set_names.hpp"

namespace pcvt {
namespace {

using Place = std::array<int, 3>;

/// The smallest and the largest offsets of the nodes of an orbit, and their number.
struct OrbitSpan {
    Place low = {};
    Place high = {};
    int n_nodes = 0;
};

Place offset_of(const ElementMesh& mesh, int node) {
    const int* const offset = &mesh.offsets[3 * static_cast<std::size_t>(node)];
    return {offset[0], offset[1], offset[2]};
}

/// The spans of the orbits, at the numbers of their representatives.
std::vector<OrbitSpan> orbit_spans(const ElementMesh& mesh) {
    std::vector<OrbitSpan> spans(static_cast<std::size_t>(mesh.n_nodes()));
    for (int v = 0; v < mesh.n_nodes(); ++v) {
        OrbitSpan& span = spans[mesh.orbit[v]];
        const Place offset = offset_of(mesh, v);
        if (span.n_nodes++ == 0) span.low = span.high = offset;
        for (int k = 0; k < 3; ++k) {
            span.low[k] = std::min(span.low[k], offset[k]);
            span.high[k] = std::max(span.high[k], offset[k]);
        }
    }
    return spans;
}

bool is_of_box(const OrbitSpan& span) {
    int n_images = 1;
    for (int k = 0; k < 3; ++k) {
        if (span.high[k] - span.low[k] > 1) return false;
        if (span.high[k] > span.low[k]) n_images *= 2;
    }
    return span.n_nodes == 0 || span.n_nodes == n_images;
}

std::string name_of(const Place& place) {
    constexpr std::array<std::string_view, 4> kWords{"", kSideSet, kEdgeSet, kCornerSet};
    const auto n = std::count_if(place.begin(), place.end(), [](int x) { return x != 0; });
    std::string name(kWords[n]);
    for (const int x : place) name += (name.ends_with('_') ? "" : "_") + std::to_string(x);
    return name;
}

}  // namespace

std::vector<BoxSet> box_sets(const ElementMesh& mesh) {
    if (mesh.dimension != 3) return {};
    const std::vector<OrbitSpan> spans = orbit_spans(mesh);
    if (!std::all_of(spans.begin(), spans.end(), is_of_box)) return {};
    // Pairs of a representative and a node, so that partners come in the same order.
    std::map<std::pair<int, Place>, std::vector<std::pair<int, int>>> found;
    for (int v = 0; v < mesh.n_nodes(); ++v) {
        const OrbitSpan& span = spans[mesh.orbit[v]];
        const Place offset = offset_of(mesh, v);
        Place place{};
        int n_sides = 0;
        for (int k = 0; k < 3; ++k) {
            if (span.low[k] == span.high[k]) continue;
            place[k] = offset[k] == span.low[k] ? 1 : -1;
            ++n_sides;
        }
        if (n_sides > 0) found[{n_sides, place}].emplace_back(mesh.orbit[v], v);
    }
    std::vector<BoxSet> sets;
    for (auto& [key, pairs] : found) {
        std::sort(pairs.begin(), pairs.end());
        BoxSet& set = sets.emplace_back(BoxSet{name_of(key.second), {}});
        for (const auto& [representative, node] : pairs) set.nodes.push_back(node);
    }
    return sets;
}

}  // namespace pcvt
