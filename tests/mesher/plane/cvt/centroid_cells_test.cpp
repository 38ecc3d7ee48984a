#include "mesher/plane/cvt/centroid_cells.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "mesher/base/error.hpp"
#include "mesher/cvt/centroid_fit.hpp"
#include "mesher/plane/geometry/polygon.hpp"
#include "mesher/plane/mesh/voronoi.hpp"
#include "tests/support/case_count.hpp"
#include "tests/support/lattices.hpp"

namespace pcvt::plane {
namespace {

/// Areas and centroids of cells, by their polygons.
struct Grains {
    Lattice lattice;
    Points centroids;
    Eigen::VectorXd areas;
};

Grains measured(const PeriodicDelaunay& delaunay) {
    const PeriodicMesh mesh = cell_mesh(delaunay);
    const int n = delaunay.sites().n_sites();
    Grains grains{mesh.lattice, Points(2, n), Eigen::VectorXd(n)};
    for (int f = 0; f < n; ++f) {
        const Polygon polygon = face_polygon(mesh, f);
        double area = 0;
        Vec2 sum = Vec2::Zero();
        for (std::size_t k = 1; k + 1 < polygon.size(); ++k) {
            const Vec2 a = polygon[k] - polygon[0];
            const Vec2 b = polygon[k + 1] - polygon[0];
            const double twice = a.x() * b.y() - a.y() * b.x();
            area += twice / 2;
            sum += twice / 6 * (a + b);
        }
        grains.areas[mesh.site[f]] = area;
        grains.centroids.col(mesh.site[f]) = polygon[0] + sum / area;
    }
    return grains;
}

Grains random_grains(const Lattice& lattice, int n, std::uint64_t seed, int steps) {
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal;
    Eigen::VectorXd areas(n);
    for (double& area : areas) area = std::exp(0.8 * normal(random));
    areas *= lattice.area() / areas.sum();
    return measured(compute_area_cvt(lattice, uniform_points(lattice, n, seed),
                                     {.areas = areas, .run = {.max_iterations = steps}})
                        .delaunay);
}

double largest_misfit(const Grains& found, const Grains& wanted) {
    const Lattice& lattice = wanted.lattice;
    double largest = 0;
    for (int s = 0; s < wanted.areas.size(); ++s) {
        const Vec2 apart = found.centroids.col(s) - wanted.centroids.col(s);
        const Vec2 whole = lattice.to_lattice(apart).array().round();
        const double off = (apart - lattice.to_position(whole)).norm();
        largest = std::max(largest, off / std::sqrt(wanted.areas.mean()));
    }
    return largest;
}

CentroidCells fitted(const Grains& grains, const RunOptions& run = {.tolerance = 1e-7}) {
    return fit_areas_and_centroids(grains.lattice, grains.centroids,
                                   {.areas = grains.areas, .run = run});
}

void expect_recovered(const Grains& grains) {
    const CentroidCells cells = fitted(grains);
    const Grains found = measured(cells.grains.delaunay);
    EXPECT_EQ(cells.grains.run.stop, Stop::kConverged);
    EXPECT_LT((found.areas - grains.areas).cwiseAbs().maxCoeff(), 1e-9 * grains.areas.mean());
    EXPECT_LT(largest_misfit(found, grains), 1e-6);
}

// Laws 1 and 2.
TEST(CentroidCells, OfPowerDiagramsAreFoundOnAllLattices) {
    std::uint64_t seed = 0;
    for (const auto& [name, lattice] : testing::lattices()) {
        for (const int n : {1, 2, 3, 5, 8, 40}) {
            SCOPED_TRACE(name + " " + std::to_string(n));
            ++seed;
            expect_recovered(random_grains(lattice, n, seed, n > 8 || seed % 3 > 0 ? 2 : 0));
        }
    }
}

// L-BFGS needs more than 100 iterations.
TEST(CentroidCells, OfRelaxedGrainsAreFoundInFewIterations) {
    const Grains grains = random_grains(Lattice::rectangle(1, 1), 300, 1, 5);
    EXPECT_LE(fitted(grains).grains.run.iterations, 10);
}

// On the way sites come near each other, from the wrong side as well.
TEST(CentroidCells, OfRandomSitesAreFound) {
    const int n_seeds = testing::case_count("PCVT_CENTROID_CASES", 4);
    for (int seed = 0; seed < n_seeds; ++seed) {
        SCOPED_TRACE(seed);
        const Grains grains = random_grains(Lattice::rectangle(1, 1), 150, seed, 0);
        expect_recovered(grains);
    }
}

TEST(CentroidCells, OfAThousandGrainsAreFound) {
    expect_recovered(random_grains(Lattice::rectangle(2, 1), 1000, 5, 5));
}

// Law 3.
TEST(CentroidCells, StateTheMisfitOfNoisyCentroids) {
    std::mt19937_64 random(9);
    std::normal_distribution<double> normal;
    Grains grains = random_grains(Lattice::rectangle(1, 1), 100, 2, 3);
    for (double& x : grains.centroids.reshaped()) {
        x += 0.05 * std::sqrt(grains.areas.mean()) * normal(random);
    }
    const CentroidCells cells = fitted(grains, {.max_iterations = 60});
    const Grains found = measured(cells.grains.delaunay);
    const double off = largest_misfit(found, grains);
    EXPECT_NEAR(cells.centroids.largest, off, 1e-9 + 1e-8 * off);
    EXPECT_LT((found.areas - grains.areas).cwiseAbs().maxCoeff(), 1e-9 * grains.areas.mean());
    EXPECT_LT(cells.centroids.mean, 0.045);
}

// Law 4: centroids that are made up belong to no power cells.
TEST(CentroidCells, KeepSitesApartForCentroidsOfNoPowerCells) {
    const Lattice lattice = Lattice::rectangle(1, 1);
    for (std::uint64_t seed = 0; seed < 6; ++seed) {
        const Points centroids = uniform_points(lattice, 2, seed);
        const Grains grains{lattice, centroids, Eigen::Vector2d::Constant(0.5)};
        const CentroidCells cells = fitted(grains, {.max_iterations = 100});
        const Sites sites = cells.grains.delaunay.sites();
        Vec2 apart = sites.coordinates().col(1) - sites.coordinates().col(0);
        apart -= Vec2(apart.array().round());
        EXPECT_GE(lattice.to_position(apart).norm(), 0.999 * kNearestSites * sites.spacing());
    }
    Points near = uniform_points(lattice, 5, 1);
    near.col(3) = near.col(1) + Vec2(1e-6, 2);
    EXPECT_THROW(fitted({lattice, near, Eigen::VectorXd::Constant(5, 0.2)}), InvalidInput);
}

TEST(CentroidCells, NeedOneAreaEach) {
    Grains grains = random_grains(Lattice::rectangle(1, 1), 4, 3, 0);
    grains.areas.conservativeResize(3);
    EXPECT_THROW(fitted(grains), InvalidInput);
}

}  // namespace
}  // namespace pcvt::plane
