#include "mesher/finite_volume/cell_flow.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "mesher/finite_volume/extruded_mesh.hpp"
#include "mesher/plane/geometry/polygon.hpp"
#include "mesher/plane/mesh/outline.hpp"
#include "mesher/plane/mesh/voronoi.hpp"
#include "mesher/plane/tile/tile_builder.hpp"
#include "mesher/space/mesh/cell_faces.hpp"
#include "tests/support/grid_tile.hpp"
#include "tests/support/lattices.hpp"
#include "tests/support/polyhedra.hpp"
#include "tests/support/random_meshes.hpp"

namespace pcvt {
namespace {

using ::testing::Each;
using testing::grid_tile;
using testing::lattices;
using testing::random_tile;

CellFlow flow_on(const plane::Tile& tile) {
    return cell_flow(DecayingFlow(tile.lattice), tile, extruded_mesh(tile));
}

plane::Polygon polygon_of(const plane::Tile& tile, int f) {
    plane::Polygon polygon;
    for (const int v : tile.faces[f]) polygon.push_back(tile.points[v]);
    return polygon;
}

TEST(CellFlow, TheMeansAreZero) {
    for (const auto& [name, lattice] : lattices()) {
        for (const plane::MeshKind kind : {plane::MeshKind::kVoronoi, plane::MeshKind::kDelaunay}) {
            const plane::Tile tile = random_tile(lattice, 300, kind);
            const CellFlow cells = flow_on(tile);
            Eigen::Vector3d momentum(0, 0, 0);
            double mass = 0;
            for (int f = 0; f < tile.n_faces(); ++f) {
                const double area = plane::polygon_area(polygon_of(tile, f));
                momentum += area * cells.velocity[f];
                mass += area * cells.tracer[f];
            }
            EXPECT_LT(momentum.norm(), 1e-11 * lattice.area()) << name;
            EXPECT_LT(std::abs(mass), 1e-11 * lattice.area()) << name;
        }
    }
}

/// The flux |u . n| through each edge is integrated by the midpoint rule on 64 parts.
double exchange_by_quadrature(const DecayingFlow& flow, const plane::Polygon& polygon) {
    double flux = 0;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const plane::Vec2& p = polygon[k];
        const plane::Vec2 edge = polygon[(k + 1) % polygon.size()] - p;
        double through = 0;
        for (int part = 0; part < 64; ++part) {
            through += plane::cross(flow.velocity(p + (part + 0.5) / 64 * edge), edge) / 64;
        }
        flux += std::abs(through);
    }
    return flux / (2 * plane::polygon_area(polygon));
}

TEST(CellFlow, NoCellExchangesMoreThanTheCourantRate) {
    for (const auto& [name, lattice] : lattices()) {
        for (const plane::MeshKind kind : {plane::MeshKind::kVoronoi, plane::MeshKind::kDelaunay}) {
            const plane::Tile tile = random_tile(lattice, 60, kind);
            double largest = 0;
            for (int f = 0; f < tile.n_faces(); ++f) {
                largest = std::max(largest, exchange_by_quadrature(DecayingFlow(tile.lattice),
                                                                   polygon_of(tile, f)));
            }
            EXPECT_NEAR(flow_on(tile).courant_rate, largest, 1e-3 * largest) << name;
        }
    }
}

TEST(CellFlow, OnAGridOfSquaresItIsTheKnownOne) {
    // The sum of both speeds is at most 1, so the rate is 1 / h less the variation along the edges.
    const CellFlow cells = flow_on(grid_tile(plane::Lattice::rectangle(1, 1), 40, 40));
    EXPECT_FALSE(cells.at_rest);
    EXPECT_NEAR(cells.courant_rate, 40, 0.2);
    EXPECT_NEAR(*std::max_element(cells.tracer.begin(), cells.tracer.end()), 1, 0.02);
}

TEST(CellFlow, CellsThatCannotRepresentItStartAtRest) {
    for (const auto& [name, lattice] : lattices()) {
        for (const int n : {1, 2}) {
            const CellFlow cells = flow_on(random_tile(lattice, n, plane::MeshKind::kVoronoi));
            EXPECT_TRUE(cells.at_rest) << name << ' ' << n;
            EXPECT_THAT(cells.velocity, Each(Eigen::Vector3d(0, 0, 0))) << name;
            EXPECT_THAT(cells.tracer, Each(0)) << name;
        }
    }
    // The centroids of 2 x 2 squares lie where the flow stagnates; long cells cross whole waves.
    EXPECT_TRUE(flow_on(grid_tile(plane::Lattice::rectangle(1, 1), 2, 2)).at_rest);
    EXPECT_TRUE(flow_on(grid_tile(plane::Lattice::rectangle(1, 1), 1, 50)).at_rest);
}

TEST(CellFlow, SmallCellsOfAnyKindMove) {
    for (const auto& [name, lattice] : lattices()) {
        const int n = static_cast<int>(DecayingFlow(lattice).rate() * lattice.area());
        for (const plane::MeshKind kind : {plane::MeshKind::kVoronoi, plane::MeshKind::kDelaunay}) {
            EXPECT_FALSE(flow_on(random_tile(lattice, n, kind)).at_rest) << name << ' ' << n;
        }
    }
}

TEST(CellFlow, InSpaceItIsTheFlowAtTheCentroids) {
    const space::Lattice cube = space::Lattice::box(1, 1, 1);
    const space::PolyhedralMesh mesh = testing::mesh_of({"", cube, testing::grid_points(8)});
    const BeltramiFlow flow(cube);
    const CellFlow cells = cell_flow(flow, mesh);
    const std::vector<space::CellBody> bodies = cell_bodies(mesh);
    for (int s = 0; s < mesh.n_cells; ++s) {
        EXPECT_EQ(cells.velocity[s], flow.velocity(bodies[s].centroid));
    }
    EXPECT_TRUE(cells.tracer.empty());
    EXPECT_EQ(cells.rate, flow.rate());
    EXPECT_EQ(cells.turn_time, flow.turn_time());
    // At most sqrt(3) through the three pairs of faces of a cube with edges of length 1 / 8.
    EXPECT_GT(cells.courant_rate, 8);
    EXPECT_LT(cells.courant_rate, 8 * std::sqrt(3));
}

}  // namespace
}  // namespace pcvt
