#include "mesher/proof/validate_power.hpp"

#include <gmock/gmock.h>

#include "mesher/areas/area_cvt.hpp"
#include "mesher/areas/target_areas.hpp"
#include "mesher/tile/build_tile.hpp"
#include "tests/support/lattices.hpp"

namespace pcvt {
namespace {

using ::testing::HasSubstr;
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
               .centroidal_steps = steps})),
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

}  // namespace
}  // namespace pcvt
