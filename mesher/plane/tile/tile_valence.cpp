#include "mesher/plane/tile/tile_valence.hpp"

#include <cmath>

#include "mesher/base/checkpoint.hpp"
#include "mesher/plane/geometry/face_polygon.hpp"
#include "mesher/plane/mesh/valence.hpp"

namespace pcvt::plane {

std::vector<int> cell_sides(const Tile& cells) {
    if (!cells.whole_sides.empty()) return cells.whole_sides;
    const double shortest = kShortEdge * std::sqrt(cells.lattice.area() / cells.n_faces());
    std::vector<int> sides(cells.n_faces());
    Polygon polygon;
    for (int f = 0; f < cells.n_faces(); ++f) {
        checkpoint_each(f);
        face_polygon(cells.points, cells.faces[f], polygon);
        sides[f] = count_sides(polygon, shortest);
    }
    return sides;
}

std::vector<int> vertex_valences(const Tile& triangles) {
    // A triangle that meets an orbit at two of its corners lies there twice.
    std::vector<int> valence(triangles.n_vertices(), 0);
    for (const int v : triangles.faces.corners) ++valence[v];
    // On a wall the triangles count with their mirror images.
    for (const WallSideRow& row : kWallSides) {
        if (!has_walls_across(triangles.walls, row.axis)) continue;
        const double line = wall_line(row, triangles.lattice);
        for (int v = 0; v < triangles.n_vertices(); ++v) {
            if (triangles.points[v][row.axis] == line) valence[v] *= 2;
        }
    }
    for (const VertexPair& pair : triangles.vertex_pairs) valence[pair.v] += valence[pair.w];
    for (const VertexPair& pair : triangles.vertex_pairs) valence[pair.w] = valence[pair.v];
    return valence;
}

}  // namespace pcvt::plane
