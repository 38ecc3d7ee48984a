#include "mesher/plane/mesh/valence.hpp"

#include <cmath>

#include "mesher/base/checkpoint.hpp"

namespace pcvt::plane {

int count_sides(std::span<const Vec2> polygon, double shortest) {
    int sides = 0;
    Vec2 from = polygon.back();
    for (const Vec2& to : polygon) {
        if ((to - from).stableNorm() > shortest) ++sides;
        from = to;
    }
    return sides;
}

std::vector<int> cell_sides(const PeriodicMesh& cells) {
    if (!cells.whole_sides.empty()) return cells.whole_sides;
    const double shortest = kShortEdge * std::sqrt(cells.lattice.area() / cells.n_faces());
    std::vector<int> sides(cells.n_faces());
    Polygon polygon;
    for (int f = 0; f < cells.n_faces(); ++f) {
        checkpoint_each(f);
        face_polygon(cells, f, polygon);
        sides[f] = count_sides(polygon, shortest);
    }
    return sides;
}

std::map<int, int> histogram(const std::vector<int>& sides) {
    std::map<int, int> counts;
    for (const int n : sides) ++counts[n];
    return counts;
}

}  // namespace pcvt::plane
