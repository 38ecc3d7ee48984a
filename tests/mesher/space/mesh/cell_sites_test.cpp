#include "mesher/space/mesh/cell_sites.hpp"

#include <gtest/gtest.h>

#include "mesher/plane/proof/validate.hpp"
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
