#include "mesher/finite_volume/mpas_grid.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "mesher/finite_volume/mpas_grid_proof.hpp"
#include "mesher/plane/cvt/cvt.hpp"
#include "mesher/plane/mesh/voronoi.hpp"
#include "tests/support/hexagons.hpp"
#include "tests/support/refusal.hpp"

namespace pcvt {
namespace {

using ::testing::HasSubstr;

MpasGrid hexagons() { return mpas_grid(testing::hexagonal_cells(6, 4), plane::Vec2(0, 0)); }

/// Returns the cells of a CVT that starts from random sites.
plane::PeriodicMesh optimized_cells(const plane::Lattice& lattice, int n, std::uint64_t seed) {
    return periodic_mesh(compute_cvt(lattice, uniform_points(lattice, n, seed), {}).delaunay,
                         plane::MeshKind::kVoronoi);
}

std::string fault_of(const plane::PeriodicMesh& cells) {
    return testing::refusal_of([&] { mpas_grid(cells, plane::Vec2(0, 0)); });
}

TEST(MpasGrid, ItsLawsHoldOnRegularAndOnOptimisedCells) {
    EXPECT_LT(prove_mpas_grid(hexagons()).trisk, 1e-14);
    int n_acute = 0;
    for (std::uint64_t seed = 0; seed < 6; ++seed) {
        for (const double height : {1.0, 0.7, 3.0}) {
            const plane::PeriodicMesh cells =
                optimized_cells(plane::Lattice::rectangle(1, height), 60, seed);
            if (!fault_of(cells).empty()) continue;
            ++n_acute;
            const MpasGridProof proof = prove_mpas_grid(mpas_grid(cells, plane::Vec2(-3.3, 0.4)));
            EXPECT_LT(proof.trisk, 1e-13);
            EXPECT_LT(proof.areas, 1e-13);
        }
    }
    EXPECT_GT(n_acute, 9);
}

TEST(MpasGrid, TheAreasOfManyEqualCellsSumToTheDomain) {
    const plane::PeriodicMesh cells = testing::hexagonal_cells(300, 300);
    EXPECT_LT(prove_mpas_grid(mpas_grid(cells, plane::Vec2(0, 0))).areas, 3e-13);
}

TEST(MpasGrid, PointsLieInTheDomainAtTheOrigin) {
    const MpasGrid grid = mpas_grid(testing::hexagonal_cells(6, 4), plane::Vec2(10, -1));
    const auto inside = [](const std::vector<double>& x, double from, double period) {
        return std::all_of(x.begin(), x.end(),
                           [&](double c) { return c >= from && c < from + period; });
    };
    EXPECT_TRUE(inside(grid.x_cell, 10, grid.x_period) && inside(grid.y_cell, -1, grid.y_period));
    EXPECT_TRUE(inside(grid.x_edge, 10, grid.x_period) && inside(grid.y_edge, -1, grid.y_period));
    EXPECT_TRUE(inside(grid.x_vertex, 10, grid.x_period));
    EXPECT_TRUE(inside(grid.y_vertex, -1, grid.y_period));
    EXPECT_NO_THROW(prove_mpas_grid(grid));
}

// The weights of regular hexagons, from J. Thuburn et al., section 4.
TEST(MpasGrid, RegularHexagonsHaveTheKnownWeights) {
    const MpasGrid grid = hexagons();
    ASSERT_EQ(grid.max_edges, 6);
    const double wanted[] = {1 / 3., 1 / 6., 0, 1 / 6., 1 / 3., 1 / 3., 1 / 6., 0, 1 / 6., 1 / 3.};
    for (int e = 0; e < grid.n_edges; ++e) {
        ASSERT_EQ(grid.n_edges_on_edge[e], 10);
        for (int k = 0; k < 10; ++k) {
            EXPECT_NEAR(std::abs(grid.weights_on_edge[12 * e + k]), wanted[k] / std::sqrt(3.0),
                        1e-14);
        }
    }
}

TEST(MpasGrid, OnRegularHexagonsAConstantFlowHasItsTangentialPart) {
    const MpasGrid grid = hexagons();
    const plane::Vec2 flow(0.3, -0.8);
    const auto normal = [&](int e) {
        return plane::Vec2(std::cos(grid.angle_edge[e]), std::sin(grid.angle_edge[e]));
    };
    for (int e = 0; e < grid.n_edges; ++e) {
        double v = 0;
        for (int k = 0; k < grid.n_edges_on_edge[e]; ++k) {
            v +=
                grid.weights_on_edge[12 * e + k] * flow.dot(normal(grid.edges_on_edge[12 * e + k]));
        }
        EXPECT_NEAR(v, flow.dot(plane::Vec2(-normal(e).y(), normal(e).x())), 1e-14);
    }
}

/// Returns the weight of edge `on` in the velocity on edge e.
double weight(const MpasGrid& grid, int e, int on) {
    double sum = 0;
    for (int k = 0; k < grid.n_edges_on_edge[e]; ++k) {
        const std::size_t entry = 2 * std::size_t(grid.max_edges) * e + k;
        if (grid.edges_on_edge[entry] == on) sum += grid.weights_on_edge[entry];
    }
    return sum;
}

// The Coriolis force does no work if d l w is antisymmetric.
TEST(MpasGrid, WeightsConserveEnergy) {
    const MpasGrid grid =
        mpas_grid(optimized_cells(plane::Lattice::rectangle(1, 1), 48, 0), plane::Vec2(0, 0));
    for (int e = 0; e < grid.n_edges; ++e) {
        for (int k = 0; k < grid.n_edges_on_edge[e]; ++k) {
            const int on = grid.edges_on_edge[2 * std::size_t(grid.max_edges) * e + k];
            EXPECT_NEAR(weight(grid, e, on) * grid.dc_edge[e] / grid.dv_edge[on],
                        -weight(grid, on, e) * grid.dc_edge[on] / grid.dv_edge[e], 1e-13);
        }
    }
}

template <class Damage>
std::string proof_after(Damage damage) {
    MpasGrid grid = hexagons();
    damage(grid);
    try {
        prove_mpas_grid(grid);
    } catch (const NotATile& fault) {
        return fault.what();
    }
    return "";
}

TEST(MpasGrid, AWrongEntryOfAnyTableBreaksALaw) {
    EXPECT_EQ(proof_after([](MpasGrid&) {}), "");
    for (const auto table :
         {&MpasGrid::cells_on_cell, &MpasGrid::edges_on_cell, &MpasGrid::vertices_on_cell,
          &MpasGrid::cells_on_edge, &MpasGrid::vertices_on_edge, &MpasGrid::edges_on_edge,
          &MpasGrid::cells_on_vertex, &MpasGrid::edges_on_vertex}) {
        EXPECT_THAT(proof_after([&](MpasGrid& g) { std::swap((g.*table)[4], (g.*table)[5]); }),
                    HasSubstr("law (1) of C-grids"));
        EXPECT_THAT(proof_after([&](MpasGrid& g) { (g.*table)[7] = 1 << 20; }),
                    HasSubstr("1048577"));
        EXPECT_THAT(proof_after([&](MpasGrid& g) { (g.*table)[7] = -1; }), HasSubstr("law (1)"));
    }
    for (const auto table : {&MpasGrid::n_edges_on_cell, &MpasGrid::n_edges_on_edge}) {
        EXPECT_THAT(proof_after([&](MpasGrid& g) { --(g.*table)[3]; }), HasSubstr("law (1)"));
    }
}

TEST(MpasGrid, AWrongNumberBreaksItsLaw) {
    const auto after = [](std::vector<double> MpasGrid::*table, double change) {
        return proof_after([&](MpasGrid& g) { (g.*table)[5] += change; });
    };
    for (const auto table : {&MpasGrid::x_cell, &MpasGrid::y_vertex, &MpasGrid::x_edge,
                             &MpasGrid::dc_edge, &MpasGrid::dv_edge, &MpasGrid::angle_edge}) {
        EXPECT_THAT(after(table, 1e-8), HasSubstr("law (2) of C-grids"));
        EXPECT_THAT(after(table, std::nan("")), HasSubstr("law (2) of C-grids"));
    }
    EXPECT_THAT(after(&MpasGrid::area_cell, 1e-10), HasSubstr("law (3) of C-grids"));
    EXPECT_THAT(after(&MpasGrid::area_triangle, 1e-10), HasSubstr("law (3) of C-grids"));
    EXPECT_THAT(after(&MpasGrid::kite_areas_on_vertex, 1e-10), HasSubstr("law (3) of C-grids"));
    EXPECT_THAT(after(&MpasGrid::weights_on_edge, 1e-10), HasSubstr("law (4) of C-grids"));
    EXPECT_THAT(proof_after([](MpasGrid& g) { g.x_period *= 1.001; }), HasSubstr("law ("));
}

TEST(MpasGrid, OnlyRectanglesAreAcceptedInAnyBasis) {
    EXPECT_EQ(rectangular_periods(plane::Lattice({0, 3}, {2, 0})), plane::Vec2(2, 3));
    EXPECT_EQ(rectangular_periods(plane::Lattice({2, 0}, {10, 3})), plane::Vec2(2, 3));
    EXPECT_EQ(rectangular_periods(plane::Lattice({1, 0}, {0.5, 0.75}).repeated(1, 2)),
              plane::Vec2(1, 1.5));
    EXPECT_THROW(rectangular_periods(plane::Lattice({1, 0}, {0.3, 0.9})), InvalidInput);
    EXPECT_THROW(rectangular_periods(plane::Lattice({1, 1}, {-1, 1})), InvalidInput);
}

TEST(MpasGrid, ObtuseAndRightTrianglesAreNamed) {
    plane::Points points(2, 4);
    points << 0, 0.5, 0, 0.5, 0, 0, 0.5, 0.5;
    const plane::PeriodicMesh squares =
        cell_mesh(plane::PeriodicDelaunay(plane::Sites(plane::Lattice::rectangle(1, 1), points)));
    EXPECT_THAT(fault_of(squares), HasSubstr("has an angle of 90.0 degrees at the first"));
    const plane::Lattice square = plane::Lattice::rectangle(1, 1);
    const plane::PeriodicMesh random =
        cell_mesh(plane::PeriodicDelaunay(plane::Sites(square, uniform_points(square, 50, 2))));
    EXPECT_THAT(fault_of(random), HasSubstr("MPAS needs acute triangles"));
}

TEST(MpasGrid, TooFewCellsForTheNearestImageAreRefused) {
    EXPECT_THAT(fault_of(testing::hexagonal_cells(2, 2)), HasSubstr("lie half a period apart"));
    EXPECT_EQ(fault_of(repeated(testing::hexagonal_cells(2, 2), 2, 2)), "");
    EXPECT_NO_THROW(prove_mpas_grid(
        mpas_grid(repeated(testing::hexagonal_cells(2, 2), 2, 2), plane::Vec2(0, 0))));
}

}  // namespace
}  // namespace pcvt
