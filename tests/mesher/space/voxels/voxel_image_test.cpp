#include "mesher/space/voxels/voxel_image.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <random>

#include "tests/support/space_lattices.hpp"

namespace pcvt::space {
namespace {

using LongVec = Eigen::Matrix<long double, 3, 1>;

LongVec centre_of(const VoxelGrid& grid, std::size_t voxel) {
    const auto nx = static_cast<std::size_t>(grid.counts.x);
    const auto ny = static_cast<std::size_t>(grid.counts.y);
    const Vec3 step(double(voxel % nx) + 0.5, double(voxel / nx % ny) + 0.5,
                    double(voxel / nx / ny) + 0.5);
    return grid.corner.cast<long double>() +
           step.cast<long double>()
               .cwiseProduct(grid.size.cast<long double>())
               .cwiseQuotient(LongVec(grid.counts.x, grid.counts.y, grid.counts.z));
}

/// The squared distance to the nearest image in a box, whose axes are those of space.
long double squared_distance(const Vec3& size, const LongVec& p, const LongVec& x) {
    LongVec d = x - p;
    for (int k = 0; k < 3; ++k) d[k] -= std::round(d[k] / size[k]) * size[k];
    return d.squaredNorm();
}

/// The number of voxels whose label is not the nearest site, or not the smallest of the nearest, by
/// all sites and in long double.
/// @param tolerance  length^2; 0 where doubles are exact.
int n_wrong(const Sites& sites, const Eigen::VectorXd& weights, const VoxelImage& image,
            double tolerance) {
    int n = 0;
    for (std::size_t v = 0; v < image.site.size(); ++v) {
        const LongVec p = centre_of(image.grid, v);
        std::vector<long double> found;
        for (SiteId s = 0; s < sites.n_sites(); ++s) {
            const LongVec x = sites.position(s).cast<long double>();
            found.push_back(squared_distance(image.grid.size, p, x) -
                            (weights.size() > 0 ? weights[s] : 0));
        }
        const auto least = std::min_element(found.begin(), found.end());
        const bool nearest = found[image.site[v]] - *least <= tolerance;
        const bool smallest = tolerance > 0 || image.site[v] == least - found.begin();
        if (!nearest || !smallest) ++n;
    }
    return n;
}

TEST(VoxelImageInSpace, Law1LabelsAreThoseOfBruteForce) {
    const std::vector<Lattice> lattices{testing::kCube,
                                        Lattice::box(1, 1, 20),
                                        Lattice::box(20, 1, 20),
                                        Lattice::box(1, 100, 1),
                                        Lattice({0, 0, 2}, {0, -1, 0}, {3, 0, 0}),
                                        Lattice({1, 0, 0}, {2, 1, 0}, {0, -3, 1.5})};
    std::uint64_t seed = 0;
    for (const int n : {1, 2, 3, 4, 5, 6, 7, 8, 13, 20, 29, 60}) {
        for (const Lattice& lattice : lattices) {
            ++seed;
            const auto delaunay =
                periodic_delaunay(Sites(lattice, uniform_points(lattice, n, seed)));
            const Vec3 origin(0.3 * double(seed % 5), -17.25, 1e3 * double(seed % 3));
            const VoxelGrid grid = voxel_grid(lattice, origin, {17, 12, 9});
            const VoxelImage image = voxel_image(delaunay, {}, grid, 1);
            const double scale = lattice.spacing(n) + origin.norm();
            EXPECT_EQ(n_wrong(delaunay.sites, {}, image, 1e-13 * scale * scale), 0)
                << n << " " << seed;
        }
    }
}

TEST(VoxelImageInSpace, Law1HoldsInAMetric) {
    std::uint64_t seed = 0;
    for (const double ratio : {0.2, 3.0, 10.0}) {
        for (const Vec3& axis : {Vec3(1, 0, 0), Vec3(1, -2, 3)}) {
            const Metric metric(ratio, axis);
            const Lattice lattice = Lattice::box(1, 2, 1.5);
            const Points points = uniform_points(lattice, 30, ++seed);
            const auto delaunay =
                periodic_delaunay(Sites(metric.to_round(lattice), metric.to_round(points)));
            const Sites sites = metric.from_round(delaunay.sites, lattice);
            const VoxelGrid grid = voxel_grid(lattice, {0.1, -3, 0}, {11, 12, 13});
            const VoxelImage image = voxel_image(delaunay, {}, grid, 2, metric);
            for (std::size_t v = 0; v < image.site.size(); v += 37) {
                const auto distance = [&](SiteId s) {
                    const Vec3 from = sites.position(s) - Vec3(centre_of(grid, v).cast<double>());
                    const Vec3 near = lattice.to_lattice(from).array().round();
                    double least = std::numeric_limits<double>::infinity();
                    for (int k = 0; k < 343; ++k) {
                        const Offset o{k / 49 - 3, k / 7 % 7 - 3, k % 7 - 3};
                        const Vec3 d = from - lattice.to_position(near + o.vector());
                        least = std::min(least, metric.to_round(d).squaredNorm());
                    }
                    return least;
                };
                const double named = distance(image.site[v]);
                for (SiteId s = 0; s < 30; ++s) ASSERT_LE(named, distance(s) + 1e-12);
            }
        }
    }
}

/// Sites with shuffled ids on a grid; all numbers are multiples of 1/64, so that doubles are exact.
TEST(VoxelImageInSpace, Law1TiesBelongToTheSmallestId) {
    std::mt19937_64 random(5);
    for (const auto kind :
         {testing::Cubic::kSimple, testing::Cubic::kBodyCentred, testing::Cubic::kFaceCentred}) {
        for (const VoxelCounts counts :
             {VoxelCounts{2, 2, 2}, {4, 4, 4}, {8, 8, 8}, {16, 4, 2}, {4, 8, 16}}) {
            for (const double start : {0.0, 1.0 / 16, 1.0 / 8}) {
                const Points grid = testing::cubic_points(kind, 2);
                std::vector<int> order(static_cast<std::size_t>(grid.cols()));
                std::iota(order.begin(), order.end(), 0);
                std::shuffle(order.begin(), order.end(), random);
                Points points(3, grid.cols());
                for (int k = 0; k < grid.cols(); ++k) {
                    points.col(order[k]) = grid.col(k) + Vec3::Constant(start);
                }
                const auto delaunay = periodic_delaunay(Sites(testing::kCube, points));
                const VoxelImage image =
                    voxel_image(delaunay, {}, voxel_grid(testing::kCube, {0, 0, 0}, counts), 1);
                EXPECT_EQ(n_wrong(delaunay.sites, {}, image, 0), 0) << counts.x << " " << start;
            }
        }
    }
}

/// Weights that leave the tetrahedra of a body-centred lattice regular: each is half as large as
/// the one that would hide a facet.
TEST(VoxelImageInSpace, Law1WeightsMoveTheCells) {
    const Points points = testing::cubic_points(testing::Cubic::kBodyCentred, 2);
    const auto delaunay = periodic_delaunay(Sites(testing::kCube, points));
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> uniform(-0.01, 0.01);
    for (const double common : {0.0, 5.0}) {
        Eigen::VectorXd weights(points.cols());
        for (double& w : weights) w = common + uniform(random);
        const VoxelGrid grid = voxel_grid(testing::kCube, {0.1, 0.2, 0.3}, {31, 24, 17});
        const VoxelImage image = voxel_image(delaunay, weights, grid, 1);
        EXPECT_EQ(n_wrong(delaunay.sites, weights, image, 1e-13), 0);
        EXPECT_NE(image.site, voxel_image(delaunay, {}, grid, 1).site);
        const Eigen::VectorXd equal = Eigen::VectorXd::Constant(points.cols(), common);
        EXPECT_EQ(voxel_image(delaunay, equal, grid, 1).site,
                  voxel_image(delaunay, {}, grid, 1).site);
    }
}

TEST(VoxelImageInSpace, Law2ARepeatedDomainRepeatsTheImage) {
    const Lattice lattice = Lattice::box(2, 1, 1);
    const auto delaunay = periodic_delaunay(Sites(lattice, uniform_points(lattice, 50, 4)));
    const VoxelImage one = voxel_image(delaunay, {}, voxel_grid(lattice, {0, 0, 0}, {32, 8, 6}), 1);
    const VoxelImage many =
        voxel_image(delaunay, {}, voxel_grid(Lattice::box(4, 3, 2), {0, 0, 0}, {64, 24, 12}), 1);
    for (int m = 0; m < 12; ++m) {
        for (int l = 0; l < 24; ++l) {
            for (int k = 0; k < 64; ++k) {
                ASSERT_EQ(many.site[(m * 24 + l) * 64 + k],
                          one.site[(m % 6 * 8 + l % 8) * 32 + k % 32]);
            }
        }
    }
}

TEST(VoxelImageInSpace, Law3TheNumberOfThreadsChangesNothing) {
    const auto delaunay =
        periodic_delaunay(Sites(testing::kCube, uniform_points(testing::kCube, 300, 4)));
    for (const VoxelCounts counts : {VoxelCounts{40, 60, 50}, {3, 70, 90}}) {
        const VoxelGrid grid = voxel_grid(testing::kCube, {0.1, 0.7, -3}, counts);
        EXPECT_EQ(voxel_image(delaunay, {}, grid, 1).site, voxel_image(delaunay, {}, grid, 4).site);
    }
}

/// The rounding of volumes by their voxels is that of random points, or less.
TEST(VoxelImageInSpace, CountsOfVoxelsAreTheVolumes) {
    const auto delaunay =
        periodic_delaunay(Sites(testing::kCube, uniform_points(testing::kCube, 20, 4)));
    const VoxelImage coarse =
        voxel_image(delaunay, {}, voxel_grid(testing::kCube, {0, 0, 0}, {32, 32, 32}), 1);
    const VoxelImage fine =
        voxel_image(delaunay, {}, voxel_grid(testing::kCube, {0, 0, 0}, {96, 96, 96}), 1);
    for (SiteId s = 0; s < 20; ++s) {
        const auto share = [s](const VoxelImage& image) {
            return double(std::count(image.site.begin(), image.site.end(), s)) /
                   double(image.site.size());
        };
        EXPECT_NEAR(share(coarse), share(fine), 0.02 * share(fine) + 1e-4);
    }
}

}  // namespace
}  // namespace pcvt::space
