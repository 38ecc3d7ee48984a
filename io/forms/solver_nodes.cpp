#include "io/forms/solver_nodes.hpp"

namespace pcvt {

SolverNodes solver_nodes(const plane::Tile& tile) {
    SolverNodes nodes{tile.points, tile.vertex_pairs, {}};
    if (tile.order != 2) return nodes;
    nodes.middles = midside_nodes(tile);
    const plane::MidsideNodes& middles = nodes.middles;
    nodes.points.insert(nodes.points.end(), middles.points.begin(), middles.points.end());
    nodes.pairs.insert(nodes.pairs.end(), middles.pairs.begin(), middles.pairs.end());
    return nodes;
}

std::vector<int> element_nodes(const plane::Tile& tile, const SolverNodes& nodes, int f) {
    const auto begin = tile.faces.begin[f];
    const auto end = tile.faces.begin[f + 1];
    std::vector<int> element(tile.faces.corners.begin() + begin, tile.faces.corners.begin() + end);
    const std::vector<int>& middles = nodes.middles.of_corner;
    if (!middles.empty()) {
        element.insert(element.end(), middles.begin() + begin, middles.begin() + end);
    }
    return element;
}

}  // namespace pcvt
