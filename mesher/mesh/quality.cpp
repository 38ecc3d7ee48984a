#include "mesher/mesh/quality.hpp"

#include <cmath>

namespace pcvt {

namespace {

/// The sides of each face, where corner(c) is the position of corner c in the frame of its face.
template <class Corner>
std::vector<int> count_sides(const std::vector<int>& face_begin, double area, Corner corner) {
    const std::size_t n_faces = face_begin.size() - 1;
    const double shortest = kShortEdge * std::sqrt(area / static_cast<double>(n_faces));
    std::vector<int> sides(n_faces, 0);
    for (std::size_t f = 0; f < n_faces; ++f) {
        Vec2 from = corner(face_begin[f + 1] - 1);
        for (int c = face_begin[f]; c < face_begin[f + 1]; ++c) {
            const Vec2 to = corner(c);
            if ((to - from).stableNorm() > shortest) ++sides[f];
            from = to;
        }
    }
    return sides;
}

}  // namespace

std::vector<int> cell_sides(const PeriodicMesh& cells) {
    if (!cells.whole_sides.empty()) return cells.whole_sides;
    return count_sides(cells.face_begin, cells.lattice.area(), [&](int c) {
        return Vec2(cells.vertices[cells.corner_vertex[c]] +
                    cells.lattice.translation(cells.corner_offset[c]));
    });
}

std::vector<int> cell_sides(const FlatTile& cells) {
    if (!cells.whole_sides.empty()) return cells.whole_sides;
    return count_sides(cells.face_begin, cells.lattice.area(),
                       [&](int c) { return cells.points[cells.corners[c]]; });
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
