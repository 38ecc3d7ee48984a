#include "mesher/plane/proof/validate_power.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "mesher/cells/target_areas.hpp"
#include "mesher/plane/cvt/area_cvt.hpp"
#include "mesher/plane/geometry/polygon.hpp"
#include "mesher/plane/proof/site_labels.hpp"
#include "mesher/plane/tile/build_tile.hpp"
#include "tests/support/example_lattices.hpp"
#include "tests/support/lattices.hpp"
#include "tests/support/power_tiles.hpp"

namespace pcvt::plane {
namespace {

using ::testing::HasSubstr;
using testing::kOblique;
using testing::lattices;
using ::testing::ThrowsMessage;

struct PowerTile {
    AreaCvtResult result;
    Tile tile;
    Points points;
    Eigen::VectorXd weights;

    PowerTile(const Lattice& lattice, int n, int steps, MeshKind kind = MeshKind::kVoronoi)
        : result(compute_area_cvt(
              lattice, uniform_points(lattice, n, 3),
              {.areas =
                   scaled_areas(draw_areas(parse_area_law("gamma:0.4"), n, 1), n, lattice.area()),
               .run = {.max_iterations = steps}})),
          tile(build_tile(result.delaunay, {.kind = kind}).tile),
          points(2, n),
          weights(result.delaunay.weights()) {
        for (SiteId s = 0; s < n; ++s) points.col(s) = result.delaunay.sites().position(s);
    }
    double proved(double tolerance) const {
        return prove_power_cells(tile, prove_tile(tile, Precision::kDouble), points, weights,
                                 tolerance);
    }
};

TEST(ProvePowerCells, CellsOfPrescribedAreasAreProved) {
    for (const auto& [name, lattice] : lattices()) {
        for (const int n : {1, 2, 3, 7, 40}) {
            for (const int steps : {0, 2}) {
                EXPECT_LT(PowerTile(lattice, n, steps).proved(1e-8), 1e-8) << name << n;
            }
        }
    }
}

TEST(ProvePowerCells, AnyImageOfASiteServes) {
    PowerTile cells(Lattice({1, 0}, {7, 1}), 20, 0);
    for (int s = 0; s < 20; ++s) {
        cells.points.col(s) += cells.tile.lattice.translation({s % 3 - 5, s % 4 + 2});
    }
    EXPECT_LT(cells.proved(1e-8), 1e-8);
}

TEST(ProvePowerCells, WrongWeightsAndSitesAreRefused) {
    const auto refuse = [](const PowerTile& cells) {
        EXPECT_THAT([&] { cells.proved(1e-6); },
                    ThrowsMessage<NotATile>(HasSubstr("off the line of equal power distance")));
    };
    const PowerTile right(Lattice::rectangle(1, 1), 20, 1);
    PowerTile weightless = right;
    weightless.weights.setZero();
    refuse(weightless);
    PowerTile changed = right;
    changed.weights[7] += 1e-6;
    refuse(changed);
    PowerTile moved = right;
    moved.points(0, 3) += 1e-5;
    refuse(moved);
    PowerTile exchanged = right;
    std::swap(exchanged.tile.face_site[2], exchanged.tile.face_site[9]);
    EXPECT_THROW(exchanged.proved(1e-6), NotATile);
}

TEST(ProvePowerCells, OtherTilesAreInvalidInput) {
    EXPECT_THROW(PowerTile(Lattice::rectangle(1, 1), 8, 0, MeshKind::kGrains).proved(1e-6),
                 InvalidInput);
    PowerTile twice(Lattice::rectangle(1, 1), 8, 0);
    twice.tile.face_site[3] = twice.tile.face_site[4];
    EXPECT_THROW(twice.proved(1e-6), InvalidInput);
}

/// The figure of `check --cvt`; -1 if the tile is refused.
double centroidal_distance(const Tile& tile, double tolerance) {
    try {
        const TileProof proof = prove_tile(tile, Precision::kDouble);
        prove_sites(tile, proof);
        return prove_voronoi(tile, proof, tolerance);
    } catch (const NotATile&) {
        return -1;
    }
}

TEST(ProveCentroidalPowerCells, SitesLieAtTheCentroidsOfAConvergedRunAlone) {
    for (const testing::CellShape& shape : {testing::cell_shapes()[0], testing::cell_shapes()[2]}) {
        for (const int columns : {1, 2}) {
            const TileOptions options{.repeat = {columns, 1}};
            const Tile tile = testing::power_tile(kOblique, 30, 3, shape, options, -1);
            const double distance = centroidal_distance(tile, 1e-5);
            EXPECT_GE(distance, 0);
            EXPECT_LT(distance, 5e-6);
            const Tile moving = testing::power_tile(kOblique, 30, 3, shape, options, 4);
            EXPECT_EQ(centroidal_distance(moving, 1e-5), -1);
            EXPECT_GT(centroidal_distance(moving, 1), 1e-3);
        }
    }
}

TEST(ProveCentroidalPowerCells, TheDistanceIsThatOfTheCentroid) {
    const Tile tile = testing::power_tile(kOblique, 12, 5, testing::cell_shapes()[0]);
    double largest = 0;
    for (int f = 0; f < tile.n_faces(); ++f) {
        Polygon polygon;
        for (const int v : tile.faces[f]) polygon.push_back(tile.points[v]);
        largest = std::max(largest, (polygon_centroid(polygon) - tile.site_points[f]).norm());
    }
    const double h = std::sqrt(kOblique.area() / 12);
    EXPECT_NEAR(centroidal_distance(tile, 10), largest / h, 1e-12);
}

TEST(ProveCentroidalPowerCells, PiecesOfCellsAreRefused) {
    const Tile tile = testing::power_tile(kOblique, 12, 5, testing::cell_shapes()[0],
                                          {.outline = Outline::kBox}, -1);
    EXPECT_EQ(centroidal_distance(tile, 1), -1);
}

TEST(ProveRegular, TrianglesAreRegularWithTheirWeightsAndInTheirMetricAlone) {
    int n_other = 0;
    for (const testing::CellShape& shape : testing::cell_shapes()) {
        for (int seed = 0; seed < 6; ++seed) {
            Tile tile = testing::power_tile(kOblique, 60, seed, shape,
                                            {.kind = MeshKind::kDelaunay, .repeat = {2, 1}});
            EXPECT_LT(centroidal_distance(tile, 1e-12), 1e-12) << shape.name;
            EXPECT_GE(centroidal_distance(tile, 1e-12), 0) << shape.name;
            tile.site_weights.clear();
            tile.metric = {};
            if (centroidal_distance(tile, 1e-6) < 0) ++n_other;
        }
    }
    EXPECT_EQ(n_other, 18);
}

}  // namespace
}  // namespace pcvt::plane
