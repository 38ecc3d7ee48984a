#include "mesher/plane/power/power_flips.hpp"

#include <gtest/gtest.h>

#include <random>

#include "mesher/plane/delaunay/periodic_delaunay.hpp"
#include "tests/support/clipped_power_cells.hpp"
#include "tests/support/lattices.hpp"
#include "tests/support/random_weights.hpp"
#include "tests/support/special_sites.hpp"
#include "tests/support/triangulation_laws.hpp"

namespace pcvt::plane {
namespace {

using testing::lattices;
using testing::random_lattice;
using testing::random_weights;

/// The smallest area of a cell, relative to the mean, of the clipped cells.
double clipped_area(const Sites& sites, const Eigen::VectorXd& weights, SiteId site) {
    const double unit = gram_unit(sites.reduction().reduced);
    const auto cells = testing::clipped_power_cells(sites, weights * unit * unit);
    return testing::polygon_moments(cells[site]).area / std::pow(sites.spacing(), 2);
}

void expect_regular(const TorusTriangulation& t, const Sites& sites,
                    const Eigen::VectorXd& weights) {
    TorusTriangulation copy = t;
    const Gram gram = gram_of(sites.reduction().reduced);
    const PowerFlips flips(copy, sites.coordinates(), gram, weights);
    testing::expect_laws(t);
    for (int h = 0; h < t.n_halfedges(); ++h) ASSERT_TRUE(flips.is_locally_regular(h));
    for (int h = 0; h < t.n_halfedges(); h += 3) {
        const auto at = [&](int k) {
            return image(sites, t.corner(h + k).site, t.corner(h + k).offset);
        };
        ASSERT_GT(orientation(at(0), at(1), at(2)), 0);
    }
}

// Laws 1 and 2.
TEST(PowerFlips, SlowEndRegularOrNameASiteThatIsHidden) {
    std::mt19937_64 random(1);
    const auto named = lattices();
    int n_regular = 0;
    int n_hidden = 0;
    for (int k = 0; k < 3000; ++k) {
        const Lattice lattice =
            k % 2 == 0 ? random_lattice(random) : named[(k / 2) % named.size()].lattice;
        const int n = 1 + k % 20;
        const Sites sites(lattice, uniform_points(lattice, n, random()));
        const Eigen::VectorXd weights = random_weights(sites, 0.1 * (1 + k % 7), random);
        SCOPED_TRACE("input " + std::to_string(k) + " n = " + std::to_string(n));
        TorusTriangulation t = PeriodicDelaunay(sites).triangulation();
        const Gram gram = gram_of(sites.reduction().reduced);
        PowerFlips flips(t, sites.coordinates(), gram, weights);
        if (const auto hidden = flips.run()) {
            ++n_hidden;
            ASSERT_LT(clipped_area(sites, weights, *hidden), 1e-12);
        } else {
            ++n_regular;
            expect_regular(t, sites, weights);
        }
        if (HasFatalFailure()) return;
    }
    EXPECT_GT(n_regular, 1000);
    EXPECT_GT(n_hidden, 500);
}

// The flips need no particular start: here the regular triangulation of other weights.
TEST(PowerFlips, ReachTheSameTriangulationFromAnyStart) {
    std::mt19937_64 random(2);
    for (int k = 0; k < 300; ++k) {
        const Lattice lattice = random_lattice(random);
        const Sites sites(lattice, uniform_points(lattice, 1 + k % 40, random()));
        const Gram gram = gram_of(sites.reduction().reduced);
        TorusTriangulation t = PeriodicDelaunay(sites).triangulation();
        const Eigen::VectorXd other = random_weights(sites, 0.3, random);
        PowerFlips(t, sites.coordinates(), gram, other).run();
        const Eigen::VectorXd weights = random_weights(sites, 0.03, random);
        SCOPED_TRACE("input " + std::to_string(k));
        if (PowerFlips(t, sites.coordinates(), gram, weights).run()) continue;
        expect_regular(t, sites, weights);
        if (HasFatalFailure()) return;
    }
}

// Law 3.
TEST(PowerFlips, EqualWeightsFlipNothingOfADelaunayTriangulation) {
    for (const auto& [name, sites] : testing::special_sites()) {
        TorusTriangulation t = PeriodicDelaunay(sites).triangulation();
        const Gram gram = gram_of(sites.reduction().reduced);
        for (const double w : {0.0, 1.0 / 3}) {
            const Eigen::VectorXd weights = Eigen::VectorXd::Constant(sites.n_sites(), w);
            PowerFlips flips(t, sites.coordinates(), gram, weights);
            EXPECT_FALSE(flips.run()) << name;
            EXPECT_EQ(flips.n_flips(), 0) << name;
        }
    }
}

}  // namespace
}  // namespace pcvt::plane
