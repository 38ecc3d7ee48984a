#include "mesher/torus/site_tree.hpp"

#include <gtest/gtest.h>

#include <random>

#include "tests/support/lattices.hpp"
#include "tests/support/nearest_site.hpp"

namespace pcvt::plane {
namespace {

TEST(SiteTree, Law1NoImageIsNearer) {
    std::mt19937_64 random(8);
    std::uniform_real_distribution<double> uniform(-3, 3);
    for (int run = 0; run < 200; ++run) {
        const Lattice lattice = testing::random_lattice(random);
        const int n = 1 + static_cast<int>(random() % 50);
        const Sites sites(lattice, uniform_points(lattice, n, random()));
        Points points(2, n);
        Eigen::VectorXd weights(run % 2 == 0 ? n : 0);
        for (SiteId s = 0; s < n; ++s) {
            points.col(s) = sites.position(s);
            if (weights.size() > 0) weights[s] = 0.1 * lattice.area() * uniform(random);
        }
        const SiteTree tree(lattice, points, weights);
        EXPECT_EQ(tree.n_sites(), n);
        const Vec2 p = lattice.to_position({uniform(random), uniform(random)});
        double least = std::numeric_limits<double>::infinity();
        for (SiteId s = 0; s < n; ++s) {
            const double weight = weights.size() > 0 ? weights[s] : 0;
            const double distance = testing::squared_distance(sites, s, p) - weight;
            EXPECT_NEAR(tree.nearest_of(s, p).power_distance(), distance, 1e-9 * lattice.area());
            least = std::min(least, distance);
        }
        const auto found = tree.nearest(p);
        EXPECT_NEAR(found.power_distance(), least, 1e-9 * lattice.area());
        EXPECT_NEAR(found.from_point.squaredNorm(), testing::squared_distance(sites, found.site, p),
                    1e-9 * lattice.area());
    }
}

}  // namespace
}  // namespace pcvt::plane
