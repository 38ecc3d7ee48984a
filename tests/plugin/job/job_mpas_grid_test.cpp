#include <gtest/gtest.h>

#include <cmath>

#include "io/mpas/mpas_reader.hpp"
#include "mesher/plane/search/lattice_pattern.hpp"
#include "plugin/job/job.hpp"
#include "plugin/job/run_job.hpp"
#include "tests/support/temporary_folder.hpp"

namespace pcvt {
namespace {

/// Returns the grid that a job writes for the sites of an exact lattice with acute triangles.
MpasGrid written_grid(const std::optional<plane::Density>& density, int columns) {
    const plane::Lattice period = plane::Lattice::rectangle(1, 2 / std::sqrt(3));
    const testing::TemporaryFolder folder;
    Job job;
    job.in_plane().lattice = period;
    job.in_plane().points = pattern_points(best_lattice(period, 48));
    job.in_plane().points.colwise() += plane::Vec2(0.01, 0.02);
    job.run.max_iterations = 0;
    job.density = density;
    job.tile.repeat.columns = columns;
    job.in_plane().origin = {5, -3};
    job.outputs = {folder / "t.nc"};
    run_job(job, {});
    return decode_mpas(job.outputs[0], testing::bytes_of(job.outputs[0]));
}

TEST(JobMpasGrid, TheMeshDensityIsRelativeToItsLargestValueAtTheSites) {
    const auto rho = [](double u) { return 2 + std::cos(2 * M_PI * u); };
    const plane::Density density =
        plane::shared_density([&](const plane::DensityPoint& p) { return 7 * rho(p.u); });
    for (const int columns : {1, 2}) {
        const MpasGrid grid = written_grid(density, columns);
        ASSERT_EQ(grid.n_cells, 48 * columns);
        double largest = 0;
        for (const double x : grid.x_cell) largest = std::max(largest, rho(x));
        for (int f = 0; f < grid.n_cells; ++f) {
            EXPECT_NEAR(grid.mesh_density[f], rho(grid.x_cell[f]) / largest, 1e-12);
        }
        EXPECT_EQ(*std::max_element(grid.mesh_density.begin(), grid.mesh_density.end()), 1);
        EXPECT_LT(*std::min_element(grid.mesh_density.begin(), grid.mesh_density.end()), 0.4);
    }
}

TEST(JobMpasGrid, WithoutADensityItIsOne) {
    const MpasGrid grid = written_grid(std::nullopt, 1);
    EXPECT_EQ(grid.mesh_density, std::vector<double>(48, 1));
}

}  // namespace
}  // namespace pcvt
