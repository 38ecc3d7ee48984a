#include <gtest/gtest.h>

#include <cmath>

#include "mesher/plane/cvt/cvt.hpp"
#include "mesher/plane/density/density_survey.hpp"
#include "mesher/plane/geometry/polygon.hpp"
#include "mesher/plane/mesh/voronoi.hpp"
#include "tests/support/densities.hpp"
#include "tests/support/example_lattices.hpp"
#include "tests/support/lattices.hpp"

namespace pcvt::plane {
namespace {

using testing::kSquare;

CvtResult optimise(const Lattice& lattice, const Density& density, int n, double tolerance) {
    CvtOptions options;
    options.run.tolerance = tolerance;
    options.density = density;
    return compute_cvt(lattice, graded_points(lattice, density, n, 2), options);
}

TEST(DensityCvt, ReachesTheTolerance) {
    for (const Density& density : {testing::smooth_density(), testing::ridge_density()}) {
        const CvtResult result = optimise(kSquare, density, 1000, 1e-9);
        EXPECT_EQ(result.run.stop, Stop::kConverged);
        EXPECT_LE(result.run.residual, 1e-9);
        EXPECT_EQ(result.density->n_rough_cells, 0);
        EXPECT_LE(result.density->quadrature_error, 1e-11);
        EXPECT_NEAR(result.density->mass_deviation, 0, 1e-10);
    }
}

// The saving comes from preconditioned long waves and from Newton's method at the end.
TEST(DensityCvt, NeedsAFractionOfTheEvaluationsOfPlainLbfgs) {
    for (const Density& density : {testing::smooth_density(), testing::ridge_density()}) {
        CvtOptions options;
        options.density = density;
        const Points points = graded_points(kSquare, density, 1000, 2);
        const CvtResult result = compute_cvt(kSquare, points, options);
        options.run.solver = Solver::kPlainLbfgs;
        const CvtResult plain = compute_cvt(kSquare, points, options);
        EXPECT_EQ(result.run.stop, Stop::kConverged);
        EXPECT_GT(result.run.hessians, 0);
        EXPECT_EQ(plain.run.hessians, 0);
        EXPECT_LT(result.run.evaluations, 0.7 * plain.run.evaluations);
        RecordProperty("evaluations", result.run.evaluations);
        RecordProperty("plain", plain.run.evaluations);
    }
}

TEST(DensityCvt, NewtonsMethodFromTheStartEndsInAMinimumToo) {
    CvtOptions options;
    options.density = testing::smooth_density();
    options.run.solver = Solver::kNewton;
    const CvtResult result =
        compute_cvt(kSquare, graded_points(kSquare, *options.density, 300, 2), options);
    EXPECT_EQ(result.run.stop, Stop::kConverged);
    EXPECT_GT(result.run.hessians, 5);
}

/// Adds the integrals of rho and of rho p over a triangle, by the midpoint rule of the sides on
/// 4^depth parts.
void add_triangle(const Lattice& lattice, const DensityFunction& rho, const Vec2& p, const Vec2& q,
                  const Vec2& r, int depth, double& mass, Vec2& first) {
    const Vec2 middles[] = {(p + q) / 2, (q + r) / 2, (r + p) / 2};
    if (depth > 0) {
        add_triangle(lattice, rho, p, middles[0], middles[2], depth - 1, mass, first);
        add_triangle(lattice, rho, q, middles[1], middles[0], depth - 1, mass, first);
        add_triangle(lattice, rho, r, middles[2], middles[1], depth - 1, mass, first);
        add_triangle(lattice, rho, middles[0], middles[1], middles[2], depth - 1, mass, first);
        return;
    }
    for (const Vec2& m : middles) {
        Vec2 u = lattice.to_lattice(m);
        u -= Vec2(u.array().floor());
        const double part = cross(q - p, r - p) / 6 *
                            testing::value_at(rho, {lattice.to_position(u).x(),
                                                    lattice.to_position(u).y(), u.x(), u.y()});
        mass += part;
        first += part * m;
    }
}

/// The largest distance between a site and the centroid of its cell by that rule, in units of h.
double independent_residual(const CvtResult& result, const Density& density, int depth) {
    const PeriodicMesh cells = periodic_mesh(result.delaunay, MeshKind::kVoronoi);
    const Lattice& lattice = cells.lattice;
    const DensityFunction rho = density.make_function();
    double largest = 0;
    for (int f = 0; f < cells.n_faces(); ++f) {
        const auto corner = [&](int c) {
            return Vec2(cells.vertices[cells.corner_vertex[c]] +
                        lattice.translation(cells.corner_offset[c]));
        };
        double mass = 0;
        Vec2 first(0, 0);
        const int begin = cells.face_begin[f];
        for (int c = begin + 1; c + 1 < cells.face_begin[f + 1]; ++c) {
            add_triangle(lattice, rho, corner(begin), corner(c), corner(c + 1), depth, mass, first);
        }
        largest = std::max(largest, (first / mass - cells.site_points[f]).norm());
    }
    return largest / std::sqrt(lattice.area() / cells.n_faces());
}

TEST(DensityCvt, SitesAreTheCentroidsOfTheirCellsByAnotherQuadrature) {
    const Lattice oblique({1, 0}, {0.37, 0.81});
    for (const Density& density : {testing::smooth_density(), testing::ridge_density()}) {
        const CvtResult result = optimise(oblique, density, 300, 1e-7);
        EXPECT_LT(independent_residual(result, density, 5), 1e-6);
        // The sites are not the centroids for rho = 1.
        const Density one = shared_density([](const DensityPoint&) { return 1.0; });
        EXPECT_GT(independent_residual(result, one, 0), 1e-3);
    }
}

TEST(DensityCvt, SpacingFollowsGershosLaw) {
    const CvtResult result = optimise(kSquare, testing::ridge_density(), 2000, 1e-2);
    EXPECT_LT(result.density->spacing_deviation, 0.03);
    EXPECT_NEAR(result.run.energy / result.density->expected_energy, 1, 0.02);
    // Uniformly random sites, which ignore the density, deviate far more.
    CvtOptions options;
    options.run.max_iterations = 0;
    options.density = testing::ridge_density();
    const CvtResult uniform = compute_cvt(kSquare, uniform_points(kSquare, 2000, 1), options);
    EXPECT_GT(uniform.density->spacing_deviation, 0.2);
}

TEST(DensityCvt, SlowSpacingOfManyCellsDeviatesByLessThanFivePercent) {
    const CvtResult result = optimise(kSquare, testing::ridge_density(), 20000, 1e-2);
    EXPECT_LT(result.density->spacing_deviation, 0.05);
}

TEST(DensityCvt, JumpsAtTheSeamAndAtBreakLinesConverge) {
    Density checkerboard = testing::checkerboard();
    checkerboard.u_breaks = checkerboard.v_breaks = {0.5};
    for (const Density& density : {testing::ramp_density(), checkerboard}) {
        const CvtResult result = optimise(kSquare, density, 300, 1e-9);
        EXPECT_EQ(result.run.stop, Stop::kConverged);
        EXPECT_EQ(result.density->n_rough_cells, 0);
    }
}

TEST(DensityCvt, AJumpWithoutBreakLinesStallsAndCountsRoughCells) {
    const CvtResult result = optimise(kSquare, testing::disc_density(), 300, 1e-9);
    EXPECT_EQ(result.run.stop, Stop::kStalled);
    EXPECT_LT(result.run.residual, 0.2);
    EXPECT_GT(result.density->n_rough_cells, 10);
    EXPECT_GT(result.density->quadrature_error, 1e-6);
}

TEST(DensityCvt, AConstantDensityGivesTheUniformEnergy) {
    const Points points = uniform_points(kSquare, 50, 4);
    CvtOptions options;
    options.run.tolerance = 1e-10;
    const CvtResult uniform = compute_cvt(kSquare, points, options);
    options.density = shared_density([](const DensityPoint&) { return 7.0; });
    const CvtResult weighted = compute_cvt(kSquare, points, options);
    // The two runs may end in different minima, whose energies differ by a few percent.
    EXPECT_NEAR(weighted.run.energy / uniform.run.energy, 7, 0.1);
    EXPECT_NEAR(weighted.density->expected_energy, 7 * uniform.energy_bound, 1e-3);
    EXPECT_FALSE(uniform.density.has_value());
}

TEST(DensityCvt, UnitsOfLengthAndDensityChangeNothing) {
    const CvtResult one = optimise(kSquare, testing::smooth_density(), 100, 1e-8);
    const Lattice large = Lattice::rectangle(1024, 1024);
    const Density scaled = shared_density([](const DensityPoint& p) {
        return std::ldexp(testing::value_at(testing::smooth_density().make_function(), p), 100);
    });
    const CvtResult other = optimise(large, scaled, 100, 1e-8);
    EXPECT_EQ(other.run.iterations, one.run.iterations);
    EXPECT_EQ(other.delaunay.sites().coordinates(), one.delaunay.sites().coordinates());
    EXPECT_DOUBLE_EQ(other.run.energy / std::ldexp(1.0, 140), one.run.energy);
    EXPECT_DOUBLE_EQ(other.density->mass / std::ldexp(1.0, 120), one.density->mass);
}

TEST(DensityCvt, IsTheSameToTheLastBitForAnyNumberOfThreads) {
    CvtOptions options;
    options.density = testing::ridge_density();
    options.run.tolerance = 1e-2;
    const Points points = graded_points(kSquare, *options.density, 1500, 3);
    const CvtResult one = compute_cvt(kSquare, points, options);
    options.run.n_threads = 3;
    const CvtResult three = compute_cvt(kSquare, points, options);
    EXPECT_EQ(three.run.energy, one.run.energy);
    EXPECT_EQ(three.delaunay.sites().coordinates(), one.delaunay.sites().coordinates());
}

TEST(DensityCvt, ProgressCountsOverAllRoundsAndCancels) {
    CvtOptions options;
    options.density = testing::smooth_density();
    std::vector<Progress> seen;
    options.run.progress = [&](const Progress& progress) {
        seen.push_back(progress);
        return true;
    };
    const Points points = graded_points(kSquare, *options.density, 100, 3);
    const CvtResult result = compute_cvt(kSquare, points, options);
    for (std::size_t k = 0; k < seen.size(); ++k) ASSERT_EQ(seen[k].iteration, static_cast<int>(k));
    EXPECT_EQ(seen.back().iteration, result.run.iterations);
    EXPECT_EQ(seen.back().evaluations, result.run.evaluations);
    EXPECT_DOUBLE_EQ(seen.back().value, result.run.energy);
    options.run.progress = [](const Progress& progress) { return progress.iteration < 40; };
    EXPECT_EQ(compute_cvt(kSquare, points, options).run.stop, Stop::kCancelled);
    options.run.progress = nullptr;
    options.run.max_iterations = 30;
    const CvtResult limited = compute_cvt(kSquare, points, options);
    EXPECT_EQ(limited.run.stop, Stop::kIterationLimit);
    EXPECT_EQ(limited.run.iterations, 30);
}

TEST(DensityCvt, SlowLloydsIterationEndsAtTheCentroids) {
    CvtOptions options;
    options.run.solver = Solver::kLloyd;
    options.run.tolerance = 1e-5;
    options.density = testing::ridge_density();
    const Points points = graded_points(kSquare, *options.density, 60, 3);
    const CvtResult result = compute_cvt(kSquare, points, options);
    EXPECT_EQ(result.run.stop, Stop::kConverged);
    EXPECT_LT(independent_residual(result, *options.density, 4), 1.2e-5);
}

TEST(DensityCvt, SmallNumbersOfSitesConverge) {
    for (const auto& [name, lattice] : testing::lattices()) {
        for (const int n : {1, 2, 7}) {
            const CvtResult result = optimise(lattice, testing::smooth_density(), n, 1e-6);
            EXPECT_EQ(result.run.stop, Stop::kConverged) << name << " n = " << n;
        }
    }
}

}  // namespace
}  // namespace pcvt::plane
