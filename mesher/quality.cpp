#include "mesher/quality.hpp"

#include <cmath>

namespace pcvt {

std::vector<int> cell_sides(const FlatTile& cells) {
    const double shortest = kShortEdge * std::sqrt(cells.lattice.area() / cells.n_faces());
    std::vector<int> sides(cells.n_faces(), 0);
    for (int f = 0; f < cells.n_faces(); ++f) {
        const int end = cells.face_begin[f + 1];
        Vec2 from = cells.points[cells.corners[end - 1]];
        for (int c = cells.face_begin[f]; c < end; ++c) {
            const Vec2 to = cells.points[cells.corners[c]];
            if ((to - from).stableNorm() > shortest) ++sides[f];
            from = to;
        }
    }
    return sides;
}

std::vector<int> vertex_valences(const FlatTile& triangles) {
    // A triangle that meets an orbit at two of its corners lies there twice.
    std::vector<int> valence(triangles.n_vertices(), 0);
    for (const int v : triangles.corners) ++valence[v];
    for (const VertexPair& pair : triangles.vertex_pairs) valence[pair.v] += valence[pair.w];
    for (const VertexPair& pair : triangles.vertex_pairs) valence[pair.w] = valence[pair.v];
    return valence;
}

std::map<int, int> histogram(const std::vector<int>& sides) {
    std::map<int, int> counts;
    for (const int n : sides) ++counts[n];
    return counts;
}

}  // namespace pcvt
