#include "tests/support/hexagons.hpp"

#include <cmath>

#include "mesher/mesh/voronoi.hpp"

namespace pcvt::testing {

PeriodicMesh hexagonal_cells(int columns, int rows) {
    const double height = std::sqrt(0.75);
    Points points(2, columns * rows);
    for (int j = 0; j < rows; ++j) {
        for (int i = 0; i < columns; ++i) {
            points.col(j * columns + i) << i + 0.5 * (j % 2), height * j;
        }
    }
    const Lattice lattice = Lattice::rectangle(columns, height * rows);
    return cell_mesh(PeriodicDelaunay(Sites(lattice, points)));
}

}  // namespace pcvt::testing
