#include "mesher/plane/cvt/area_cvt.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "mesher/base/error.hpp"
#include "mesher/cells/target_areas.hpp"
#include "mesher/plane/geometry/polygon.hpp"
#include "mesher/plane/mesh/cell_measures.hpp"
#include "mesher/plane/mesh/voronoi.hpp"
#include "mesher/plane/proof/generated_tile.hpp"
#include "mesher/plane/tile/build_tile.hpp"
#include "tests/support/lattices.hpp"

namespace pcvt::plane {
namespace {

using testing::lattices;

Eigen::VectorXd law_areas(const char* law, const Lattice& lattice, int n, std::uint64_t seed) {
    return scaled_areas(draw_areas(parse_area_law(law), n, seed), n, lattice.area());
}

double largest_error(const CellTable& cells, const Eigen::VectorXd& areas) {
    double largest = 0;
    for (SiteId s = 0; s < cells.n_cells(); ++s) {
        largest = std::max(largest, std::abs(cells.measure[s] - areas[s]) / areas[s]);
    }
    return largest;
}

TEST(AreaCvt, CellsHaveTheirAreasOnEveryLattice) {
    for (const auto& [name, lattice] : lattices()) {
        for (const int n : {1, 2, 3, 4, 5, 7, 8, 60}) {
            for (const int steps : {0, 3}) {
                SCOPED_TRACE(name + " n = " + std::to_string(n));
                const Eigen::VectorXd areas = law_areas("gamma:0.4", lattice, n, 5);
                const AreaCvtResult result =
                    compute_area_cvt(lattice, uniform_points(lattice, n, 2),
                                     {.areas = areas, .run = {.max_iterations = steps}});
                EXPECT_TRUE(result.areas.converged);
                // Some few sites lie at the centroids of their cells from the start.
                EXPECT_EQ(result.run.stop, result.run.residual <= RunOptions().tolerance
                                               ? Stop::kConverged
                                               : Stop::kIterationLimit);
                EXPECT_EQ(result.run.iterations, steps);
                const PeriodicMesh cells = cell_mesh(result.delaunay);
                // Merged corners move an area by 1e-9 of the length of an edge.
                EXPECT_LT(largest_error(cell_table(cells), areas), 1e-8);
            }
        }
    }
}

TEST(AreaCvt, EveryMeshOfPowerCellsIsATile) {
    for (const auto& [name, lattice] : lattices()) {
        const Eigen::VectorXd areas = law_areas("lognormal:0.42", lattice, 40, 5);
        const AreaCvtResult result =
            compute_area_cvt(lattice, uniform_points(lattice, 40, 2),
                             {.areas = areas, .run = {.max_iterations = 3}});
        for (const MeshKind kind : {MeshKind::kVoronoi, MeshKind::kDelaunay, MeshKind::kGrains}) {
            for (const Outline outline : {Outline::kWhole, Outline::kBox}) {
                if (kind == MeshKind::kDelaunay && outline == Outline::kBox) continue;
                SCOPED_TRACE(name);
                const BuiltTile built =
                    build_tile(result.delaunay, {.kind = kind, .outline = outline});
                EXPECT_NO_THROW(verify_generated_tile(built.tile));
            }
        }
    }
}

TEST(AreaCvt, FiveStepsGiveTheCircularityOfGrains) {
    const Lattice unit = Lattice::rectangle(1, 1);
    for (std::uint64_t seed = 1; seed < 4; ++seed) {
        const Eigen::VectorXd areas = law_areas("lognormal:0.42", unit, 1000, seed);
        const AreaCvtResult result = compute_area_cvt(
            unit, uniform_points(unit, 1000, seed), {.areas = areas, .run = {.max_iterations = 5}});
        const CellTable cells = cell_table(cell_mesh(result.delaunay));
        double sum = 0;
        for (SiteId s = 0; s < 1000; ++s) sum += 1 - cells.roundness(s);
        EXPECT_GT(sum / 1000, 0.095);
        EXPECT_LT(sum / 1000, 0.105);
    }
}

TEST(AreaCvt, EndsCentroidalInTheSameAreas) {
    const Lattice unit = Lattice::rectangle(1, 1);
    const Eigen::VectorXd areas = law_areas("lognormal:0.42", unit, 300, 1);
    const AreaCvtResult result =
        compute_area_cvt(unit, uniform_points(unit, 300, 1),
                         {.areas = areas, .run = {.tolerance = 1e-6, .max_iterations = -1}});
    EXPECT_EQ(result.run.stop, Stop::kConverged);
    EXPECT_LE(result.run.residual, 1e-6);
    EXPECT_LT(result.areas.largest_relative_error, 1e-10);
    const PeriodicMesh cells = cell_mesh(result.delaunay);
    EXPECT_LT(largest_error(cell_table(cells), areas), 1e-8);
    for (int f = 0; f < cells.n_faces(); ++f) {
        Polygon polygon;
        for (int c = cells.face_begin[f]; c < cells.face_begin[f + 1]; ++c) {
            polygon.push_back(cells.point(c));
        }
        EXPECT_LT((polygon_centroid(polygon) - cells.site_points[f]).norm(),
                  2e-6 * result.delaunay.sites().spacing());
    }
}

TEST(AreaCvt, TheGradientIsTheDerivativeOfTheEnergyInFixedAreas) {
    // A step along the direction of the centroids lowers the energy as its gradient says.
    const Lattice unit = Lattice::rectangle(1, 1);
    const Eigen::VectorXd areas = law_areas("gamma:0.3", unit, 30, 1);
    const Points points = uniform_points(unit, 30, 1);
    const auto energy = [&](const Points& p) {
        return compute_area_cvt(unit, p, {.areas = areas}).run.energy;
    };
    const AreaCvtResult here = compute_area_cvt(unit, points, {.areas = areas});
    const PeriodicMesh cells = cell_mesh(here.delaunay);
    for (int s = 0; s < 30; s += 7) {
        Polygon polygon;
        for (int c = cells.face_begin[s]; c < cells.face_begin[s + 1]; ++c) {
            polygon.push_back(cells.point(c));
        }
        const Vec2 gradient = 2 * areas[s] * (cells.site_points[s] - polygon_centroid(polygon));
        for (int k = 0; k < 2; ++k) {
            constexpr double kStep = 1e-5;
            Points moved = points;
            moved(k, s) += kStep;
            const double above = energy(moved);
            moved(k, s) -= 2 * kStep;
            EXPECT_NEAR((above - energy(moved)) / (2 * kStep), gradient[k], 1e-7);
        }
    }
}

TEST(AreaCvt, TheResultDoesNotDependOnTheNumberOfThreads) {
    const Lattice lattice({1, 0}, {0.37, 0.81});
    const Eigen::VectorXd areas = law_areas("gamma:0.3", lattice, 20'000, 1);
    const auto run = [&](int n_threads) {
        return compute_area_cvt(
            lattice, uniform_points(lattice, 20'000, 1),
            {.areas = areas, .run = {.max_iterations = 1, .n_threads = n_threads}});
    };
    const AreaCvtResult one = run(1);
    const AreaCvtResult three = run(3);
    EXPECT_EQ(one.delaunay.weights(), three.delaunay.weights());
    EXPECT_EQ(one.delaunay.sites().coordinates(), three.delaunay.sites().coordinates());
}

TEST(AreaCvt, ACancelledRunReturnsItsLastDiagram) {
    const Lattice unit = Lattice::rectangle(1, 1);
    const Eigen::VectorXd areas = law_areas("gamma:0.3", unit, 50, 1);
    const AreaCvtResult result = compute_area_cvt(
        unit, uniform_points(unit, 50, 1),
        {.areas = areas, .run = {.max_iterations = 9, .progress = [](const Progress& now) {
                                     return now.iteration < 2;
                                 }}});
    EXPECT_EQ(result.run.stop, Stop::kCancelled);
    EXPECT_EQ(result.run.iterations, 2);
    EXPECT_LT(largest_error(cell_table(cell_mesh(result.delaunay)), areas), 1e-8);
}

TEST(AreaCvt, AWrongNumberOfAreasIsRefused) {
    const Lattice unit = Lattice::rectangle(1, 1);
    EXPECT_THROW(compute_area_cvt(unit, uniform_points(unit, 5, 1),
                                  {.areas = Eigen::VectorXd::Constant(4, 0.25)}),
                 InvalidInput);
}

}  // namespace
}  // namespace pcvt::plane
