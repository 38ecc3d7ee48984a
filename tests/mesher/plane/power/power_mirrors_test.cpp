#include "mesher/plane/power/power_mirrors.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "mesher/plane/delaunay/mirror_diagram.hpp"
#include "mesher/plane/delaunay/periodic_delaunay.hpp"
#include "mesher/plane/power/power_flips.hpp"
#include "tests/support/lattices.hpp"
#include "tests/support/random_weights.hpp"
#include "tests/support/special_sites.hpp"

namespace pcvt::plane {
namespace {

using testing::lattices;
using testing::random_lattice;
using testing::random_weights;

using Corners = std::array<std::pair<SiteId, Offset>, 3>;

/// The triangles as a set, up to translations.
std::vector<Corners> triangle_set(const std::vector<Triangle>& triangles) {
    std::vector<Corners> set;
    for (const Triangle& t : triangles) {
        Corners corners;
        for (int k = 0; k < 3; ++k) corners[k] = {t[k].site, t[k].offset};
        Corners best;
        bool first = true;
        for (const auto& [site, origin] : Corners(corners)) {
            Corners moved = corners;
            for (auto& [s, offset] : moved) offset = offset - origin;
            std::sort(moved.begin(), moved.end());
            if (first || moved < best) best = moved;
            first = false;
        }
        set.push_back(best);
    }
    std::sort(set.begin(), set.end());
    return set;
}

std::vector<Corners> triangle_set(const TorusTriangulation& t) {
    std::vector<Triangle> triangles;
    for (int h = 0; h < t.n_halfedges(); h += 3) {
        triangles.push_back({t.corner(h), t.corner(h + 1), t.corner(h + 2)});
    }
    return triangle_set(triangles);
}

// The paper's mirrors carry over to power cells.
TEST(PowerMirrors, EqualTheFullCopiesAndTheFlips) {
    std::mt19937_64 random(1);
    const auto named = lattices();
    int n_visible = 0;
    for (int k = 0; k < 1000; ++k) {
        const int n = 1 + k % 40;
        const Lattice lattice =
            k % 2 == 0 ? random_lattice(random) : named[(k / 2) % named.size()].lattice;
        SCOPED_TRACE("input " + std::to_string(k) + " n = " + std::to_string(n));
        const Sites sites(lattice, uniform_points(lattice, n, random()));
        const Eigen::VectorXd weights = random_weights(sites, 0.1 * (1 + k % 10), random);
        const PowerMirrors mirrors = power_mirrors(sites, weights);
        ASSERT_EQ(triangle_set(mirrors.triangles),
                  triangle_set(power_copies(sites, weights).triangles));
        TorusTriangulation t = PeriodicDelaunay(sites).triangulation();
        const Gram gram = gram_of(sites.reduction().reduced);
        const auto hidden = PowerFlips(t, sites.coordinates(), gram, weights).run();
        ASSERT_EQ(hidden.has_value(), mirrors.triangles.size() < 2 * std::size_t(n));
        if (hidden) continue;
        ++n_visible;
        ASSERT_EQ(triangle_set(t), triangle_set(mirrors.triangles));
    }
    EXPECT_GT(n_visible, 300);
}

TEST(PowerMirrors, EqualTheFullCopiesWhereSitesAreCocircularOrOnTheSeam) {
    std::mt19937_64 random(2);
    for (const auto& [name, sites] : testing::special_sites()) {
        SCOPED_TRACE(name);
        for (const double size : {0.0, 0.2, 1.0}) {
            const Eigen::VectorXd weights = random_weights(sites, size, random);
            ASSERT_EQ(triangle_set(power_mirrors(sites, weights).triangles),
                      triangle_set(power_copies(sites, weights).triangles));
        }
    }
}

TEST(PowerMirrors, WithoutWeightsTheyAreThePapersMirrors) {
    for (const auto& [name, lattice] : lattices()) {
        const Sites sites(lattice, uniform_points(lattice, 200, 3));
        const PowerMirrors power = power_mirrors(sites, Eigen::VectorXd::Zero(200));
        const MirrorDiagram paper = mirror_diagram(sites);
        EXPECT_EQ(power.n_mirrors, paper.n_mirrors) << name;
        EXPECT_EQ(triangle_set(power.triangles), triangle_set(paper.triangles)) << name;
    }
}

// A heavy site next to the seam pushes the cell of a light one out of the domain of its site.
TEST(PowerMirrors, FindACellThatLiesOutsideOfTheDomainOfItsSite) {
    Points points(2, 2);
    points << 0.6, 0.97, 0.5, 0.5;
    const Sites sites(Lattice::rectangle(1, 1), points);
    const double unit = gram_unit(sites.reduction().reduced);
    Eigen::VectorXd weights(2);
    weights << 0.2 / (unit * unit), 0;
    const PowerMirrors mirrors = power_mirrors(sites, weights);
    EXPECT_EQ(mirrors.triangles.size(), 4u);
    EXPECT_EQ(triangle_set(mirrors.triangles),
              triangle_set(power_copies(sites, weights).triangles));
}

}  // namespace
}  // namespace pcvt::plane
