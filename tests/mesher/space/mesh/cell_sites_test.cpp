#include "mesher/space/mesh/cell_sites.hpp"

#include <gtest/gtest.h>

#include "mesher/plane/proof/validate.hpp"
#include "mesher/space/cvt/weighted_cells.hpp"
#include "mesher/space/mesh/cell_measures.hpp"
#include "tests/support/polyhedra.hpp"

namespace pcvt::space {
namespace {

TEST(CellSites, LieInTheirCells) {
    for (const testing::SpaceCase& c : testing::space_cases()) {
        SCOPED_TRACE(c.name);
        const Sites sites(c.lattice, c.points);
        const PolyhedralMesh mesh = testing::mesh_of(c);
        const Points images = sites_in_cells(sites, mesh);
        EXPECT_LT(prove_cell_sites(mesh, images).from_bisector, 1e-8);
        for (SiteId s = 0; s < sites.n_sites(); ++s) {
            const Vec3 u = c.lattice.to_lattice(images.col(s) - sites.position(s));
            EXPECT_LT((u.array() - u.array().round()).abs().maxCoeff(), 1e-9);
        }
    }
}

TEST(CellSites, OfALatticeAreCentroids) {
    const testing::SpaceCase c{"", Lattice::box(1, 1, 1), testing::lattice_points(54)};
    const PolyhedralMesh mesh = testing::mesh_of(c);
    const Points images = sites_in_cells(Sites(c.lattice, c.points), mesh);
    EXPECT_LT(prove_cell_sites(mesh, images).from_centroid, 1e-12);
}

/// The plane between two sites 2e-9 h apart turns by 1e-8 with the rounding of their positions.
TEST(CellSites, NearToEachOtherAreProved) {
    const Lattice oblique({1, 0, 0}, {0.140122976, 1, 0},
                          {0.474352681, -0.0734729592, 0.787108855});
    Points points(3, 3);
    points << 0.73536622917840194, 0.73536623069313855, 0.45286248161639768,  //
        0.43224226723033954, 0.43224226723033954, 0.24803254706060253,        //
        0.86351992151642851, 0.86351992151642851, 0.075958954034036298;
    const PolyhedralMesh mesh = testing::mesh_of({"", oblique, points});
    const Points images = sites_in_cells(Sites(oblique, points), mesh);
    EXPECT_NO_THROW(prove_cell_sites(mesh, images));
    Points moved = images;
    moved(1, 1) += 1e-12;
    EXPECT_THROW(prove_cell_sites(mesh, moved), NotATile);
}

/// Balls of different radii: the cells of their sites, with weights, and not without.
TEST(CellSites, OfPowerCellsNeedTheirWeights) {
    const Lattice cube = Lattice::box(1, 1, 1);
    const Points points = uniform_points(cube, 40, 4);
    const Eigen::VectorXd weights = 0.003 * Eigen::VectorXd::LinSpaced(40, 0, 1);
    const WeightedCells cells = weighted_cells(cube, points, weights, {});
    const PeriodicDelaunay& delaunay = cells.delaunay;
    const CellComplex complex = cell_complex(delaunay.sites, delaunay.tetrahedra, delaunay.weights);
    const CellTable table = cell_table(complex);
    for (SiteId s = 0; s < 40; ++s) EXPECT_NEAR(table.measure[s] / cells.cell_volumes[s], 1, 1e-10);
    std::vector<Offset> images;
    const PolyhedralMesh mesh = polyhedral_mesh(delaunay.sites, complex, {3, -2, 0.5}, &images);
    const Points sites = sites_of_cells(complex, images);
    EXPECT_LT(prove_cell_sites(mesh, sites, delaunay.weights).from_bisector, 1e-8);
    EXPECT_THROW(prove_cell_sites(mesh, sites), NotATile);
    Eigen::VectorXd other = delaunay.weights;
    other[7] += 1e-6;
    EXPECT_THROW(prove_cell_sites(mesh, sites, other), NotATile);
}

TEST(CellSites, AreRefutedWhereTheyBelongToOtherCells) {
    const Lattice cube = Lattice::box(1, 1, 1);
    const testing::SpaceCase c{"", cube, uniform_points(cube, 30, 2)};
    const PolyhedralMesh mesh = testing::mesh_of(c);
    const Points images = sites_in_cells(Sites(cube, c.points), mesh);
    Points exchanged = images;
    exchanged.col(0).swap(exchanged.col(mesh.neighbour[0]));
    EXPECT_THROW(prove_cell_sites(mesh, exchanged), NotATile);
    Points moved = images;
    moved(2, 7) += 1e-6;
    EXPECT_THROW(prove_cell_sites(mesh, moved), NotATile);
    Points translated = images;
    translated.col(3) += cube.a();
    EXPECT_THROW(prove_cell_sites(mesh, translated), NotATile);
    EXPECT_THROW(prove_cell_sites(mesh, images.leftCols(29)), NotATile);
}

}  // namespace
}  // namespace pcvt::space
