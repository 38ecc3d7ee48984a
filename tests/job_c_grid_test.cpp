#include <gtest/gtest.h>
#include <stdlib.h>

#include <cmath>
#include <filesystem>

#include "io/mpas_reader.hpp"
#include "io/text.hpp"
#include "mesher/lattice_pattern.hpp"
#include "plugin/job.hpp"

namespace pcvt {
namespace {

/// The C-grid that a job writes whose sites stay at an exact lattice of acute triangles.
CGrid written_grid(const std::optional<Density>& density, int columns) {
    const Lattice period = Lattice::rectangle(1, 2 / std::sqrt(3));
    std::string folder = std::filesystem::temp_directory_path() / "pcvt-XXXXXX";
    EXPECT_NE(::mkdtemp(folder.data()), nullptr);
    Job job;
    job.lattice = period;
    job.points = pattern_points(best_lattice(period, 48));
    job.points.colwise() += Vec2(0.01, 0.02);
    job.max_iterations = 0;
    job.density = density;
    job.columns = columns;
    job.origin = {5, -3};
    job.outputs = {folder + "/t.nc"};
    run_job(job, {});
    CGrid grid = decode_mpas(job.outputs[0], read_whole_file(job.outputs[0]));
    std::filesystem::remove_all(folder);
    return grid;
}

TEST(JobCGrid, TheMeshDensityIsThatOfTheSitesOverItsLargestValue) {
    const auto rho = [](double u) { return 2 + std::cos(2 * M_PI * u); };
    const Density density = shared_density([&](const DensityPoint& p) { return 7 * rho(p.u); });
    for (const int columns : {1, 2}) {
        const CGrid grid = written_grid(density, columns);
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

TEST(JobCGrid, WithoutADensityItIsOne) {
    const CGrid grid = written_grid(std::nullopt, 1);
    EXPECT_EQ(grid.mesh_density, std::vector<double>(48, 1));
}

}  // namespace
}  // namespace pcvt
