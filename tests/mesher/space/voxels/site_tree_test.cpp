#include "mesher/torus/site_tree.hpp"

#include <gtest/gtest.h>

#include <random>

#include "tests/support/space_lattices.hpp"

namespace pcvt::space {
namespace {

/// The least power distance to an image of a site, of 9 x 9 x 9 images in the reduced basis.
double least_of(const Sites& sites, SiteId site, double weight, const Vec3& p) {
    const Lattice& reduced = sites.reduction().reduced;
    const Vec3 whole = reduced.to_lattice(p - sites.position(site)).array().round();
    double least = std::numeric_limits<double>::infinity();
    for (int i = -4; i <= 4; ++i) {
        for (int j = -4; j <= 4; ++j) {
            for (int k = -4; k <= 4; ++k) {
                const Vec3 x = sites.position(site) + reduced.to_position(whole + Vec3(i, j, k));
                least = std::min(least, (x - p).squaredNorm() - weight);
            }
        }
    }
    return least;
}

struct Case {
    Sites sites;
    Eigen::VectorXd weights;
    SiteTree<Lattice> tree;
};

Case drawn(const Lattice& lattice, int n, double largest_weight) {
    const Points points = uniform_points(lattice, n, n);
    Eigen::VectorXd weights(n);
    for (int s = 0; s < n; ++s) weights[s] = largest_weight * ((s * 7) % 5) / 5.0;
    return {Sites(lattice, points), weights, SiteTree<Lattice>(lattice, points, weights)};
}

TEST(SiteTreeInSpace, Law1NoImageIsNearer) {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> uniform(-3, 3);
    for (const auto& [name, lattice] : testing::space_lattices()) {
        for (const int n : {1, 2, 9, 40}) {
            const double h = lattice.spacing(n);
            for (const double largest : {0.0, 0.5 * h * h}) {
                const Case c = drawn(lattice, n, largest);
                for (int k = 0; k < 10; ++k) {
                    const Vec3 p = lattice.to_position({uniform(random), uniform(random), 0.3});
                    double least = std::numeric_limits<double>::infinity();
                    for (SiteId s = 0; s < n; ++s) {
                        const double of_site = least_of(c.sites, s, c.weights[s], p);
                        EXPECT_NEAR(c.tree.nearest_of(s, p).power_distance(), of_site,
                                    1e-10 * p.squaredNorm() + 1e-12 * h * h);
                        least = std::min(least, of_site);
                    }
                    EXPECT_NEAR(c.tree.nearest(p).power_distance(), least,
                                1e-10 * p.squaredNorm() + 1e-12 * h * h)
                        << name;
                }
            }
        }
    }
}

TEST(SiteTreeInSpace, Law2ABoxHasTheNearestImageOfEachOfItsPoints) {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> uniform(-1, 1);
    for (const auto& [name, lattice] : testing::space_lattices()) {
        const double width = reduce(lattice).reduced.heights().minCoeff();
        for (const int n : {1, 2, 9, 40, 300}) {
            const double h = lattice.spacing(n);
            const Case c = drawn(lattice, n, 0.3 * h * h);
            for (const double part : {0.0, 0.1, 0.5}) {
                const Vec3 half = part * std::min(h, width) * Vec3(1, 0.5, 0.8);
                const Vec3 p = lattice.to_position({uniform(random), 1.3, uniform(random)});
                const auto images = c.tree.nearest_in_box(p, half);
                for (int k = 0; k < 20; ++k) {
                    const Vec3 from_p =
                        half.cwiseProduct(Vec3(uniform(random), uniform(random), uniform(random)));
                    double least = std::numeric_limits<double>::infinity();
                    for (const NearestImage<3>& image : images) {
                        least = std::min(least,
                                         (image.from_point - from_p).squaredNorm() - image.weight);
                    }
                    EXPECT_NEAR(least, c.tree.nearest(p + from_p).power_distance(),
                                1e-10 * (p.squaredNorm() + h * h))
                        << name << " " << n;
                }
            }
        }
    }
}

}  // namespace
}  // namespace pcvt::space
