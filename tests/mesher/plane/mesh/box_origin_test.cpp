#include "mesher/plane/mesh/box_origin.hpp"

#include <gtest/gtest.h>

#include "mesher/plane/mesh/box_outline.hpp"
#include "mesher/plane/mesh/voronoi.hpp"
#include "tests/support/lattices.hpp"
#include "tests/support/random_meshes.hpp"
#include "tests/support/special_sites.hpp"

namespace pcvt::plane {
namespace {

using testing::random_cells;

double shortest_at(const PeriodicMesh& cells, const Vec2& origin) {
    return cut_along_box(cells, origin).shortest_edge;
}

TEST(BoxOrigin, LeavesLongerEdgesThanRandomOrigins) {
    for (const auto& [name, lattice] : testing::lattices()) {
        for (const int n : {1, 40}) {
            const PeriodicMesh cells = random_cells(lattice, n, 2);
            const double found = shortest_at(cells, find_box_origin(cells));
            const Points others = uniform_points(lattice, 30, 9);
            for (int k = 0; k < 30; ++k) {
                EXPECT_GT(found, shortest_at(cells, others.col(k))) << name << " n = " << n;
            }
        }
    }
}

TEST(BoxOrigin, AvoidsTheEdgesOfExactGrids) {
    for (const int n : {1, 2, 8, 16, 64}) {
        const Sites sites = testing::grid_sites(Lattice::rectangle(1, 1), n, n, 0.5 / n, 0.5 / n);
        const PeriodicMesh cells = cell_mesh(PeriodicDelaunay(sites));
        EXPECT_GT(shortest_at(cells, find_box_origin(cells)), 0.25 / n) << n;
    }
}

// The best cut of one square cell halves all of its edges.
TEST(BoxOrigin, FindsTheBestCutOfASquare) {
    const Sites sites = testing::grid_sites(Lattice::rectangle(1, 1), 1, 1, 0.3, 0.6);
    const PeriodicMesh cells = cell_mesh(PeriodicDelaunay(sites));
    EXPECT_NEAR(shortest_at(cells, find_box_origin(cells)), 0.5, 1e-3);
}

}  // namespace
}  // namespace pcvt::plane
