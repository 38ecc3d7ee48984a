#include "mesher/plane/voxels/voxel_image.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "mesher/cells/target_areas.hpp"
#include "mesher/plane/cvt/area_cvt.hpp"
#include "tests/support/lattices.hpp"
#include "tests/support/special_sites.hpp"

namespace pcvt::plane {
namespace {

using testing::grid_sites;

/// A diagram in the plane of a metric.
PeriodicDelaunay diagram(const Lattice& lattice, int n, const char* law, const Metric& metric,
                         std::uint64_t seed) {
    const Lattice round = metric.to_round(lattice);
    const Points points = uniform_points(round, n, seed);
    const Eigen::VectorXd areas =
        scaled_areas(draw_areas(parse_area_law(law), n, seed), n, round.area());
    return compute_area_cvt(round, points, {.areas = areas, .run = {.max_iterations = 2}}).delaunay;
}

/// The power distances of a point to the nearest image of each site, from 9 x 9 images of the
/// reduced basis, in long double.
std::vector<long double> distances(const PeriodicDelaunay& delaunay, const Metric& metric,
                                   const Vec2& p) {
    const Sites& sites = delaunay.sites();
    const Lattice& reduced = sites.reduction().reduced;
    const Vec2 q = metric.to_round(p);
    const Vec2 u = reduced.to_lattice(q);
    const Offset near{wrap(u.x()).whole, wrap(u.y()).whole};
    std::vector<long double> least;
    for (SiteId s = 0; s < sites.n_sites(); ++s) {
        least.push_back(std::numeric_limits<long double>::infinity());
        for (int i = -4; i <= 4; ++i) {
            for (int j = -4; j <= 4; ++j) {
                const Vec2 image = sites.position(s) + reduced.translation(near + Offset{i, j});
                const long double x = (long double)(image.x()) - q.x();
                const long double y = (long double)(image.y()) - q.y();
                least.back() = std::min(least.back(), x * x + y * y);
            }
        }
        if (delaunay.weights().size() > 0) least.back() -= delaunay.weights()[s];
    }
    return least;
}

Vec2 centre(const VoxelGrid& grid, int k, int l) {
    return grid.corner + Vec2((k + 0.5) * grid.spacing().x(), (l + 0.5) * grid.spacing().y());
}

/// The number of voxels whose label is not the nearest site, or not the smallest of the nearest.
/// @param rounding  relative to the area of a cell; 0 where doubles are exact.
int n_wrong(const PeriodicDelaunay& delaunay, const Metric& metric, const VoxelImage& image,
            double rounding) {
    const Sites& sites = delaunay.sites();
    const double tolerance = rounding * sites.lattice().area();
    int n = 0;
    for (std::size_t v = 0; v < image.site.size(); ++v) {
        const int k = static_cast<int>(v) % image.grid.counts.x;
        const int l = static_cast<int>(v) / image.grid.counts.x;
        const auto found = distances(delaunay, metric, centre(image.grid, k, l));
        const auto least = std::min_element(found.begin(), found.end());
        const bool nearest = found[image.site[v]] - *least <= tolerance;
        const bool smallest = rounding > 0 || image.site[v] == least - found.begin();
        if (!nearest || !smallest) ++n;
    }
    return n;
}

TEST(VoxelImage, Law1LabelsAreThoseOfBruteForce) {
    std::uint64_t seed = 0;
    for (const auto& [name, lattice] : testing::lattices()) {
        if (lattice.a().y() != 0 || lattice.b().x() != 0) continue;
        for (const int n : {1, 2, 3, 4, 5, 6, 7, 8, 60}) {
            for (const double ratio : {1.0, 4.0}) {
                for (const char* law : {"equal", "lognormal:0.6"}) {
                    const Metric metric(ratio, 30);
                    const auto delaunay = diagram(lattice, n, law, metric, ++seed);
                    const VoxelGrid grid =
                        voxel_grid(lattice, lattice.to_position({0.3, -2.6}), {17, 12});
                    const VoxelImage image = voxel_image(delaunay, metric, grid, 1);
                    EXPECT_EQ(n_wrong(delaunay, metric, image, 1e-13), 0) << name << " " << n;
                }
            }
        }
    }
}

/// Sites with shuffled ids on a grid; all numbers are multiples of 1/64, so that doubles are exact.
TEST(VoxelImage, Law1TiesBelongToTheSmallestId) {
    std::mt19937_64 random(5);
    for (const VoxelCounts counts : {VoxelCounts{2, 2}, {4, 4}, {8, 8}, {16, 4}, {4, 32}}) {
        for (const double start : {0.0, 1.0 / 16, 1.0 / 8}) {
            Points points(2, 16);
            std::vector<int> order(16);
            std::iota(order.begin(), order.end(), 0);
            std::shuffle(order.begin(), order.end(), random);
            for (int k = 0; k < 16; ++k) {
                points.col(order[k]) = Vec2(start + k % 4 / 4.0, start + k / 4 / 4.0);
            }
            const Lattice unit = Lattice::rectangle(1, 1);
            const PeriodicDelaunay delaunay(Sites(unit, points));
            const VoxelImage image = voxel_image(delaunay, {}, voxel_grid(unit, {0, 0}, counts), 1);
            EXPECT_EQ(n_wrong(delaunay, {}, image, 0), 0) << counts.x << " " << start;
        }
    }
}

TEST(VoxelImage, Law2ARepeatedDomainRepeatsTheImage) {
    const Lattice lattice = Lattice::rectangle(2, 1);
    const auto delaunay = diagram(lattice, 50, "gamma:0.4", {}, 4);
    const VoxelImage one = voxel_image(delaunay, {}, voxel_grid(lattice, {0, 0}, {64, 16}), 1);
    const VoxelImage six =
        voxel_image(delaunay, {}, voxel_grid(lattice.repeated(2, 3), {0, 0}, {128, 48}), 1);
    for (int l = 0; l < 48; ++l) {
        for (int k = 0; k < 128; ++k) {
            ASSERT_EQ(six.site[l * 128 + k], one.site[(l % 16) * 64 + k % 64]);
        }
    }
}

TEST(VoxelImage, Law3TheNumberOfThreadsChangesNothing) {
    const Lattice lattice = Lattice::rectangle(1, 1);
    const auto delaunay = diagram(lattice, 300, "lognormal:0.42", {}, 4);
    for (const VoxelCounts counts : {VoxelCounts{200, 100}, {100, 200}}) {
        const VoxelGrid grid = voxel_grid(lattice, {0.1, 0.7}, counts);
        EXPECT_EQ(voxel_image(delaunay, {}, grid, 1).site, voxel_image(delaunay, {}, grid, 4).site);
    }
}

TEST(VoxelImage, ObliqueSitesHaveARectangularRepetition) {
    const Lattice hexagonal({1, 0}, {0.5, std::sqrt(0.75)});
    const auto delaunay = diagram(hexagonal, 20, "gamma:0.4", {}, 4);
    const VoxelGrid grid = voxel_grid(hexagonal.repeated(1, 2), {0.2, 0.1}, {40, 60});
    EXPECT_EQ(n_wrong(delaunay, {}, voxel_image(delaunay, {}, grid, 1), 1e-13), 0);
}

TEST(VoxelImage, TheCostIsThatOfVoxelsAndSites) {
    const Lattice lattice = Lattice::rectangle(1, 1);
    for (const int n : {1, 1000, 30'000}) {
        const PeriodicDelaunay delaunay(Sites(lattice, uniform_points(lattice, n, 2)));
        for (const VoxelCounts counts :
             {VoxelCounts{2, 2}, {2, 5000}, {5000, 2}, {100, 100}, {400, 400}}) {
            const auto before = predicate_counts().calls;
            voxel_image(delaunay, {}, voxel_grid(lattice, {0, 0}, counts), 1);
            const auto calls = predicate_counts().calls - before;
            EXPECT_LT(calls, 20 * (std::int64_t{counts.x} * counts.y + n)) << n << " " << counts.x;
        }
    }
}

}  // namespace
}  // namespace pcvt::plane
