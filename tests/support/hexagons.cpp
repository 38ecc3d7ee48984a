#include "tests/support/hexagons.hpp"

#include <cmath>

#include "mesher/plane/mesh/voronoi.hpp"

namespace pcvt::testing {

plane::PeriodicMesh hexagonal_cells(int columns, int rows) {
    const double height = std::sqrt(0.75);
    plane::Points points(2, columns * rows);
    for (int j = 0; j < rows; ++j) {
        for (int i = 0; i < columns; ++i) {
            points.col(j * columns + i) << i + 0.5 * (j % 2), height * j;
        }
    }
    const plane::Lattice lattice = plane::Lattice::rectangle(columns, height * rows);
    return cell_mesh(plane::PeriodicDelaunay(plane::Sites(lattice, points)));
}

}  // namespace pcvt::testing
