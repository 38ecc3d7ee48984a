#include "mesher/plane/mesh/cell_measures.hpp"

#include <cmath>

#include "mesher/base/checkpoint.hpp"
#include "mesher/plane/geometry/polygon.hpp"
#include "mesher/plane/mesh/valence.hpp"

namespace pcvt::plane {

CellTable cell_table(const PeriodicMesh& cells) {
    const double shortest = kShortEdge * std::sqrt(cells.lattice.area() / cells.n_faces());
    CellTable table;
    for (int f = 0; f < cells.n_faces(); ++f) {
        checkpoint_each(f);
        const int begin = cells.face_begin[f];
        const int end = cells.face_begin[f + 1];
        // Near the origin, the area keeps its digits.
        const Vec2 first = cells.point(begin);
        Polygon polygon;
        for (int c = begin; c < end; ++c) polygon.push_back(cells.point(c) - first);
        table.measure.push_back(polygon_area(polygon));
        table.surface.push_back(polygon_perimeter(polygon));
        int n_sides = 0;
        for (int c = begin; c < end; ++c) {
            const Vec2 edge = cells.point(cells.next(c)) - cells.point(c);
            if (!(edge.stableNorm() > shortest)) continue;
            ++n_sides;
            if (cells.opposite[c] < 0) continue;
            table.neighbours.push_back(cells.site[cells.corner_face[cells.opposite[c]]]);
        }
        table.sides.push_back(n_sides);
        table.neighbour_begin.push_back(static_cast<int>(table.neighbours.size()));
    }
    return table;
}

}  // namespace pcvt::plane
