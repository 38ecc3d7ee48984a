#include "mesher/plane/cvt/cell_areas.hpp"

#include <gmock/gmock.h>

#include "mesher/base/error.hpp"
#include "mesher/cells/target_areas.hpp"
#include "mesher/plane/cvt/area_cvt.hpp"
#include "tests/support/clipped_power_cells.hpp"
#include "tests/support/lattices.hpp"

namespace pcvt::plane {
namespace {

using ::testing::HasSubstr;

Eigen::VectorXd wanted_areas(const Lattice& lattice, int n, int seed) {
    return scaled_areas(draw_areas(parse_area_law("lognormal:0.42"), n, seed), n, lattice.area());
}

// Laws 1 and 2.
TEST(CellAreas, AreThoseOfTheHalfPlanesAndThoseThatWereAskedFor) {
    int seed = 0;
    for (const auto& [name, lattice] : testing::lattices()) {
        for (const int n : {1, 2, 3, 8, 40}) {
            const Eigen::VectorXd wanted = wanted_areas(lattice, n, ++seed);
            const AreaCvtResult run =
                compute_area_cvt(lattice, uniform_points(lattice, n, seed), {.areas = wanted});
            const Sites& sites = run.delaunay.sites();
            const CellAreas cells = power_cell_areas(sites, run.delaunay.weights());
            const std::vector<Polygon> twins =
                testing::clipped_power_cells(sites, run.delaunay.weights());
            for (int s = 0; s < n; ++s) {
                EXPECT_NEAR(cells.area[s], polygon_area(twins[s]), 1e-9 * wanted[s]) << name;
                EXPECT_NEAR(cells.area[s], wanted[s], 2e-10 * wanted[s]) << name << ' ' << n;
            }
        }
    }
}

TEST(CellAreas, AWeightChangesAnAreaByItsSensitivity) {
    const Lattice lattice({1, 0}, {0.37, 0.81});
    const AreaCvtResult run = compute_area_cvt(lattice, uniform_points(lattice, 30, 1),
                                               {.areas = wanted_areas(lattice, 30, 1)});
    const Sites& sites = run.delaunay.sites();
    const CellAreas cells = power_cell_areas(sites, run.delaunay.weights());
    for (int s = 0; s < 30; ++s) {
        Eigen::VectorXd weights = run.delaunay.weights();
        weights[s] += 1e-8;
        const double change = power_cell_areas(sites, weights).area[s] - cells.area[s];
        EXPECT_NEAR(change, 1e-8 * cells.sensitivity[s], 1e-12);
    }
}

TEST(CellAreas, TheWorstCellIsNamedAndRoundingIsTolerated) {
    const Lattice lattice({1, 0}, {0.37, 0.81});
    const Metric metric(3, 30);
    const Eigen::VectorXd wanted = wanted_areas(lattice, 30, 1);
    const Points points = uniform_points(lattice, 30, 1);
    const AreaCvtResult run =
        compute_area_cvt(metric.to_round(lattice), metric.to_round(points), {.areas = wanted});
    StatedCells cells{.lattice = lattice,
                      .metric = metric,
                      .points = points,
                      .weights = run.delaunay.weights(),
                      .rounding = 1e-15,
                      .weight_rounding = 1e-16};
    EXPECT_LE(compare_areas(cells, wanted).error, 1e-9);
    Eigen::VectorXd others = wanted;
    others[7] *= 1 + 1e-8;
    const AreaComparison found = compare_areas(cells, others);
    EXPECT_EQ(found.site, 7);
    EXPECT_NEAR(found.error, 1e-8, 1e-9);
    EXPECT_EQ(found.tolerance, 1e-9);
    // The numbers of a file of 32 bits.
    cells.points = points.cast<float>().cast<double>();
    cells.weights = cells.weights.cast<float>().cast<double>().eval();
    const AreaComparison refused = compare_areas(cells, wanted);
    EXPECT_GT(refused.error, refused.tolerance);
    cells.rounding = 4 * 0x1p-23;
    cells.weight_rounding = 0x1p-23;
    const AreaComparison rounded = compare_areas(cells, wanted);
    EXPECT_LE(rounded.error, rounded.tolerance);
    EXPECT_LT(rounded.tolerance, 1e-2);
}

TEST(CellAreas, ASiteWithoutACellIsNamed) {
    const Lattice lattice = Lattice::rectangle(1, 1);
    const Sites sites(lattice, uniform_points(lattice, 10, 1));
    Eigen::VectorXd weights = Eigen::VectorXd::Zero(10);
    weights[4] = -1;
    try {
        power_cell_areas(sites, weights);
        FAIL();
    } catch (const InvalidInput& fault) {
        EXPECT_THAT(fault.what(), HasSubstr("site 4 has no cell"));
    }
}

}  // namespace
}  // namespace pcvt::plane
