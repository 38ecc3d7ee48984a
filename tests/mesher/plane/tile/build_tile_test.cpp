#include "mesher/plane/tile/build_tile.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "mesher/plane/proof/generated_tile.hpp"
#include "tests/support/lattices.hpp"

namespace pcvt::plane {
namespace {

PeriodicDelaunay delaunay_of(const Lattice& lattice, int n) {
    return PeriodicDelaunay(Sites(lattice, uniform_points(lattice, n, 3)));
}

TEST(BuildTile, EveryKindAndOutlineIsProved) {
    for (const auto& [name, lattice] : testing::lattices()) {
        SCOPED_TRACE(name);
        const PeriodicDelaunay delaunay = delaunay_of(lattice, 6);
        for (const MeshKind kind : {MeshKind::kVoronoi, MeshKind::kGrains}) {
            for (const Outline outline : {Outline::kWhole, Outline::kBox}) {
                const BuiltTile built = build_tile(delaunay, {.kind = kind, .outline = outline});
                const TileProof proof = verify_generated_tile(built.tile);
                EXPECT_EQ(built.figures.n_boundary_edges, proof.n_boundary_edges);
                EXPECT_EQ(built.figures.box_shortest_edge.has_value(), outline == Outline::kBox);
                EXPECT_EQ(built.figures.grains.has_value(), kind == MeshKind::kGrains);
            }
        }
    }
}

TEST(BuildTile, RepetitionsCoverTheRepeatedLattice) {
    const Lattice lattice({1, 0}, {0.37, 0.81});
    const BuiltTile built =
        build_tile(delaunay_of(lattice, 5), {.kind = MeshKind::kDelaunay, .repeat = {2, 3}});
    EXPECT_EQ(built.tile.n_faces(), 2 * 5 * 6);
    EXPECT_EQ(built.tile.lattice.b(), lattice.repeated(2, 3).b());
    EXPECT_NO_THROW(verify_generated_tile(built.tile));
}

TEST(BuildTile, WholeTilesLieAroundTheGivenRectangle) {
    const Lattice lattice = Lattice::rectangle(3, 1);
    const BuiltTile built = build_tile(delaunay_of(lattice, 60), {.origin = {5, -2}});
    EXPECT_EQ(built.figures.domain_corner, Vec2(5, -2));
    EXPECT_EQ(built.figures.opposite_corner, Vec2(8, -1));
    const double h = std::sqrt(lattice.area() / 60);
    for (const Vec2& site : built.tile.site_points) {
        EXPECT_LT(std::abs(site.x() - 6.5), 1.5 + 2 * h);
        EXPECT_LT(std::abs(site.y() + 1.5), 0.5 + 2 * h);
    }
}

TEST(BuildTile, OnlyGrainsHaveTheOrderTwo) {
    const PeriodicDelaunay delaunay = delaunay_of(Lattice::rectangle(1, 1), 4);
    EXPECT_EQ(build_tile(delaunay, {.kind = MeshKind::kGrains, .order = 2}).tile.order, 2);
    EXPECT_EQ(build_tile(delaunay, {.kind = MeshKind::kVoronoi, .order = 2}).tile.order, 1);
}

}  // namespace
}  // namespace pcvt::plane
