#include "mesher/space/cvt/weighted_cells.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "mesher/base/error.hpp"
#include "tests/support/space_lattices.hpp"
#include "tests/support/space_laws.hpp"
#include "tests/support/space_power_mirrors.hpp"
#include "tests/support/space_weights.hpp"

namespace pcvt::space {
namespace {

// Law 1.
TEST(SpaceWeightedCells, WithEqualWeightsAreVoronoiCells) {
    const Points points = uniform_points(testing::kCube, 40, 1);
    const auto cells = weighted_cells(testing::kCube, points, Eigen::VectorXd::Constant(40, 7), {});
    const CvtResult voronoi = compute_cvt(testing::kCube, points, {.run = {.max_iterations = 0}});
    EXPECT_EQ(testing::canonical_tetrahedra(cells.delaunay.tetrahedra),
              testing::canonical_tetrahedra(voronoi.delaunay.tetrahedra));
    EXPECT_NEAR(cells.run.energy, voronoi.run.energy, 1e-13 * voronoi.run.energy);
    EXPECT_NEAR(cells.run.residual, voronoi.run.residual, 1e-12);
    EXPECT_EQ(cells.delaunay.weights, Eigen::VectorXd::Constant(40, 7));
    EXPECT_NEAR(cells.cell_volumes.sum(), 1, 1e-13);
}

// Law 2.
TEST(SpaceWeightedCells, DependOnlyOnDifferencesOfWeights) {
    std::mt19937_64 random(1);
    const Sites sites(testing::kCube, uniform_points(testing::kCube, 60, 2));
    // Multiples of 2^-40, so that sums with 1024 are exact.
    Eigen::VectorXd weights = testing::random_space_weights(sites, 0.05, random);
    for (double& w : weights) w = std::round(w * 0x1p40) * 0x1p-40;
    const auto cells = weighted_cells(testing::kCube, sites.positions(), weights, {});
    const auto moved =
        weighted_cells(testing::kCube, sites.positions(), weights.array() + 1024, {});
    EXPECT_EQ(cells.cell_volumes, moved.cell_volumes);
    EXPECT_EQ(testing::canonical_tetrahedra(cells.delaunay.tetrahedra),
              testing::space_power_mirrors(cells.delaunay.sites, weights).tetrahedra);
}

// Law 3.
TEST(SpaceWeightedCells, NameTheSitesThatTheDiagramOfAllCopiesLacks) {
    std::mt19937_64 random(2);
    int n_empty = 0;
    for (int k = 0; k < 60; ++k) {
        const Lattice lattice = testing::random_space_lattice(random);
        const Sites sites(lattice, uniform_points(lattice, 2 + k % 14, random()));
        const Eigen::VectorXd weights = testing::random_space_weights(sites, 1, random);
        const auto mirrors = testing::space_power_mirrors(sites, weights);
        SCOPED_TRACE("input " + std::to_string(k));
        try {
            weighted_cells(lattice, sites.positions(), weights, {});
            ASSERT_TRUE(mirrors.hidden.empty());
        } catch (const EmptyCells& error) {
            ++n_empty;
            ASSERT_EQ(error.sites(), mirrors.hidden);
        }
    }
    EXPECT_GT(n_empty, 20);
}

TEST(SpaceWeightedCells, NameNoMoreThanTwentySitesWhateverTheirWeights) {
    Eigen::VectorXd weights(30);
    for (int s = 0; s < 30; ++s) weights[s] = s == 3 ? 1e300 : -1e306 * s;
    try {
        weighted_cells(testing::kCube, uniform_points(testing::kCube, 30, 1), weights, {});
        FAIL();
    } catch (const EmptyCells& error) {
        EXPECT_EQ(error.sites().size(), EmptyCells::kMostNamed);
        EXPECT_EQ(std::count(error.sites().begin(), error.sites().end(), 3), 0);
    }
}

TEST(SpaceWeightedCells, RefuseWeightsThatAreMissingOrNotFinite) {
    const Points points = uniform_points(testing::kCube, 3, 1);
    const double infinite = std::numeric_limits<double>::infinity();
    EXPECT_THROW(weighted_cells(testing::kCube, points, Eigen::Vector2d(0, 0), {}), InvalidInput);
    EXPECT_THROW(weighted_cells(testing::kCube, points, Eigen::Vector3d(0, infinite, 0), {}),
                 InvalidInput);
}

}  // namespace
}  // namespace pcvt::space
