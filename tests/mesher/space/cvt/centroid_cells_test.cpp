#include "mesher/space/cvt/centroid_cells.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "mesher/base/error.hpp"
#include "mesher/cvt/centroid_fit.hpp"
#include "mesher/space/cvt/weighted_cells.hpp"
#include "mesher/space/mesh/cell_complex.hpp"
#include "tests/support/space_lattices.hpp"

namespace pcvt::space {
namespace {

/// Volumes and centroids of cells, by their polyhedra.
struct Grains {
    Lattice lattice;
    Points centroids;
    Eigen::VectorXd volumes;
};

Grains measured(const PeriodicDelaunay& delaunay) {
    const Lattice& lattice = delaunay.sites.lattice();
    const int n = delaunay.sites.n_sites();
    Grains grains{lattice, Points(3, n), Eigen::VectorXd(n)};
    const std::vector<CellBody> bodies =
        cell_bodies(cell_complex(delaunay.sites, delaunay.tetrahedra, delaunay.weights));
    for (int s = 0; s < n; ++s) {
        grains.centroids.col(s) = bodies[s].centroid;
        grains.volumes[s] = bodies[s].volume;
    }
    return grains;
}

/// Cells of random sites with lognormal volumes, after some centroidal steps.
Grains random_grains(const Lattice& lattice, int n, std::uint64_t seed, int steps) {
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal;
    Eigen::VectorXd volumes(n);
    for (double& volume : volumes) volume = std::exp(normal(random));
    volumes *= lattice.volume() / volumes.sum();
    return measured(compute_volume_cvt(lattice, uniform_points(lattice, n, seed),
                                       {.volumes = volumes, .run = {.max_iterations = steps}})
                        .delaunay);
}

/// The distances of centroids from those wanted, modulo the lattice, in h: the largest, the mean.
CentroidFigures misfit(const Grains& found, const Grains& wanted) {
    const Lattice& lattice = wanted.lattice;
    const auto n = static_cast<int>(wanted.volumes.size());
    CentroidFigures figures;
    for (int s = 0; s < n; ++s) {
        const Vec3 apart = found.centroids.col(s) - wanted.centroids.col(s);
        const Vec3 whole = lattice.to_lattice(apart).array().round();
        const double off = (apart - lattice.to_position(whole)).norm() / lattice.spacing(n);
        figures.largest = std::max(figures.largest, off);
        figures.mean += off / n;
    }
    return figures;
}

CentroidCells fitted(const Grains& grains, RunOptions run = {.tolerance = 1e-7}) {
    return fit_volumes_and_centroids(grains.lattice, grains.centroids,
                                     {.volumes = grains.volumes, .run = std::move(run)});
}

void expect_recovered(const Grains& grains) {
    const CentroidCells cells = fitted(grains);
    const Grains found = measured(cells.grains.delaunay);
    const double mean = grains.volumes.mean();
    EXPECT_EQ(cells.grains.run.stop, Stop::kConverged);
    EXPECT_LT((found.volumes - grains.volumes).cwiseAbs().maxCoeff(), 1e-9 * mean);
    EXPECT_LT(misfit(found, grains).largest, 1e-6);
    EXPECT_LE(cells.centroids.largest, 1e-7);
}

// Laws 1 and 2.
TEST(CentroidCellsInSpace, OfPowerDiagramsAreFoundOnAllLattices) {
    std::uint64_t seed = 0;
    for (const auto& [name, lattice] : testing::space_lattices()) {
        for (const int n : {1, 2, 3, 4, 5, 8, 30}) {
            // Cells of a needle become slabs, whose centroids hardly depend on the sites.
            if (name == "needle" && n > 4) continue;
            SCOPED_TRACE(name + " " + std::to_string(n));
            ++seed;
            expect_recovered(random_grains(lattice, n, seed, seed % 3 == 0 ? 0 : 2));
        }
    }
}

TEST(CentroidCellsInSpace, OfAThousandGrainsAreFound) {
    expect_recovered(random_grains(Lattice::box(2, 1, 1), 1000, 5, 5));
}

// A power diagram of balls far from its centroids.
TEST(CentroidCellsInSpace, OfBallsAreFound) {
    const Lattice lattice = testing::kCube;
    const Points points = uniform_points(lattice, 60, 4);
    Eigen::VectorXd weights(60);
    for (int s = 0; s < 60; ++s) weights[s] = 1e-3 * (s % 4);
    const Grains grains = measured(weighted_cells(lattice, points, weights, {}).delaunay);
    expect_recovered(grains);
}

// Law 3.
TEST(CentroidCellsInSpace, StateTheMisfitOfNoisyCentroids) {
    std::mt19937_64 random(9);
    std::normal_distribution<double> normal;
    for (const double noise : {0.05, 0.3}) {
        Grains grains = random_grains(testing::kCube, 60, 2, 3);
        for (double& x : grains.centroids.reshaped()) {
            x += noise / std::sqrt(3.0) * testing::kCube.spacing(60) * normal(random);
        }
        const CentroidCells cells = fitted(grains, {.tolerance = 1e-7, .max_iterations = 40});
        const Grains found = measured(cells.grains.delaunay);
        const CentroidFigures off = misfit(found, grains);
        EXPECT_NEAR(cells.centroids.largest, off.largest, 1e-9 + 1e-8 * off.largest);
        EXPECT_NEAR(cells.centroids.mean, off.mean, 1e-9 + 1e-8 * off.mean);
        EXPECT_EQ(cells.grains.run.residual, cells.centroids.largest);
        EXPECT_LT((found.volumes - grains.volumes).cwiseAbs().maxCoeff(),
                  1e-9 * grains.volumes.mean());
        // The cells come nearer than the noise.
        EXPECT_LT(off.mean, 0.7 * noise);
    }
}

// Law 4.
TEST(CentroidCellsInSpace, DoNotDependOnThreadsNorOnImages) {
    Grains grains = random_grains(testing::kCube, 80, 3, 2);
    const CentroidCells one = fitted(grains, {.max_iterations = 7});
    const CentroidCells three = fitted(grains, {.max_iterations = 7, .n_threads = 3});
    EXPECT_EQ(one.grains.run.stop, Stop::kIterationLimit);
    EXPECT_EQ(one.grains.delaunay.weights, three.grains.delaunay.weights);
    EXPECT_EQ(one.grains.delaunay.sites.coordinates(), three.grains.delaunay.sites.coordinates());
    EXPECT_EQ(one.centroids.mean, three.centroids.mean);
    for (int s = 0; s < 80; ++s) grains.centroids.col(s) += Vec3(s % 3, -(s % 5), s % 2);
    expect_recovered(grains);
}

/// The distance of the nearest two sites, in h.
double nearest(const PeriodicDelaunay& delaunay) {
    const Sites& sites = delaunay.sites;
    double least = 1e300;
    for (int s = 0; s < sites.n_sites(); ++s) {
        for (int t = 0; t < s; ++t) {
            Vec3 apart = sites.coordinates().col(s) - sites.coordinates().col(t);
            apart -= Vec3(apart.array().round());
            least = std::min(least, sites.reduction().reduced.to_position(apart).norm());
        }
    }
    return least / sites.spacing();
}

// Law 5: centroids that are made up belong to no power cells, and sites come near each other.
TEST(CentroidCellsInSpace, KeepSitesApartForCentroidsOfNoPowerCells) {
    double least = 1;
    for (const int n : {2, 3, 12}) {
        for (std::uint64_t seed = 0; seed < 2; ++seed) {
            SCOPED_TRACE(std::to_string(n) + " " + std::to_string(seed));
            const Points centroids = uniform_points(testing::kCube, n, seed);
            const Grains grains{testing::kCube, centroids, Eigen::VectorXd::Constant(n, 1.0 / n)};
            const CentroidCells cells = fitted(grains, {.tolerance = 1e-6, .max_iterations = 100});
            EXPECT_LE(cells.grains.largest_error, 1e-10);
            const double apart = nearest(cells.grains.delaunay);
            EXPECT_GE(apart, 0.999 * kNearestSites);
            least = std::min(least, apart);
            const Grains found = measured(cells.grains.delaunay);
            EXPECT_LT((found.volumes - grains.volumes).cwiseAbs().maxCoeff(), 1e-9 / n);
        }
    }
    // Without the bound they would coincide.
    EXPECT_LT(least, 1e-4);
}

TEST(CentroidCellsInSpace, RefuseCentroidsThatNearlyCoincide) {
    Points centroids = uniform_points(testing::kCube, 5, 1);
    centroids.col(3) = centroids.col(1) + Vec3(1e-6, 0, 2);
    try {
        fitted({testing::kCube, centroids, Eigen::VectorXd::Constant(5, 0.2)});
        FAIL();
    } catch (const InvalidInput& error) {
        EXPECT_STREQ(error.what(),
                     "the centroids of grains 1 and 3 nearly coincide, which those of no power "
                     "cells do; correct one of them, or merge the two grains");
    }
}

TEST(CentroidCellsInSpace, NeedVolumesAndDistinctCentroids) {
    Grains grains = random_grains(testing::kCube, 4, 3, 0);
    Grains few = grains;
    few.volumes.conservativeResize(3);
    EXPECT_THROW(fitted(few), InvalidInput);
    Grains large = grains;
    large.volumes *= 2;
    EXPECT_THROW(fitted(large), InvalidInput);
    grains.centroids.col(2) = grains.centroids.col(1) + Vec3(1, 0, 0);
    EXPECT_THROW(fitted(grains), DuplicateSites);
}

}  // namespace
}  // namespace pcvt::space
