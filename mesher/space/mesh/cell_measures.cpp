#include "mesher/space/mesh/cell_measures.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "mesher/base/checkpoint.hpp"
#include "mesher/space/mesh/vector_area.hpp"

namespace pcvt::space {
namespace {

/// The area of a plane face, length^2.
double face_area(const CellComplex& complex, int f) {
    const Vec3 sum = twice_vector_area(
        complex.corners_of(f), [&](const VertexImage& corner) { return complex.position(corner); });
    // Files state areas, and Eigen's norm() adds in another order on other platforms.
    return std::sqrt(sum.x() * sum.x() + sum.y() * sum.y() + sum.z() * sum.z()) / 2;
}

}  // namespace

CellTable cell_table(const CellComplex& complex) {
    const auto n = static_cast<std::size_t>(complex.n_cells);
    CellTable table;
    table.dimension = 3;
    for (const CellBody& body : cell_bodies(complex)) table.measure.push_back(body.volume);
    table.surface.assign(n, 0);
    table.sides.assign(n, 0);
    std::vector<std::pair<SiteId, SiteId>> pairs;
    for (int f = 0; f < complex.n_faces(); ++f) {
        checkpoint_each(f);
        const CellFace& face = complex.faces[f];
        const double area = face_area(complex, f);
        for (const auto& pair :
             {std::pair(face.cell, face.neighbour), std::pair(face.neighbour, face.cell)}) {
            table.surface[pair.first] += area;
            ++table.sides[pair.first];
            pairs.push_back(pair);
        }
    }
    std::sort(pairs.begin(), pairs.end());
    for (std::size_t s = 0; s < n; ++s) {
        table.neighbour_begin.push_back(table.neighbour_begin.back() + table.sides[s]);
    }
    for (const auto& pair : pairs) table.neighbours.push_back(pair.second);
    return table;
}

}  // namespace pcvt::space
