#include "mesher/space/box/cut_edges.hpp"

#include <algorithm>

namespace pcvt::space {

std::vector<CutEdge> boundaries_of(std::vector<CutEdge> edges) {
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    std::vector<CutEdge> left;
    for (const CutEdge& edge : edges) {
        const CutEdge reversed{edge.cell, edge.plane, edge.to, edge.from};
        if (!std::binary_search(edges.begin(), edges.end(), reversed)) left.push_back(edge);
    }
    return left;
}

std::vector<VertexImage> cycle_of(std::span<const CutEdge> edges) {
    std::vector<VertexImage> cycle;
    VertexImage at = edges[0].from;
    do {
        const auto next = std::lower_bound(
            edges.begin(), edges.end(), at,
            [](const CutEdge& e, const VertexImage& image) { return e.from < image; });
        if (next == edges.end() || next->from != at || cycle.size() == edges.size()) return {};
        cycle.push_back(at);
        at = next->to;
    } while (at != edges[0].from);
    if (cycle.size() != edges.size()) return {};
    return cycle;
}

}  // namespace pcvt::space
