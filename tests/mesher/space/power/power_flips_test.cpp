#include "mesher/space/power/power_flips.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "tests/support/random_space_sites.hpp"
#include "tests/support/space_cells.hpp"
#include "tests/support/space_families.hpp"
#include "tests/support/space_laws.hpp"
#include "tests/support/space_power_mirrors.hpp"
#include "tests/support/space_weights.hpp"

namespace pcvt::space {
namespace {

enum class End { kRegular, kHidden, kStuck };

/// Law 1 or 2; the end of the flips.
/// @param weights  length^2.
End expect_laws(const Sites& sites, TorusTetrahedra& t, const Eigen::VectorXd& weights) {
    const Gram gram = gram_of(sites.reduction().reduced);
    const Eigen::VectorXd of_gram = testing::gram_weights(sites, weights);
    PowerFlips flips(t, sites.coordinates(), gram, of_gram);
    const bool regular = flips.flip(flips.irregular_facets());
    testing::expect_torus(t, sites.coordinates());
    if (regular) {
        EXPECT_TRUE(flips.irregular_facets().empty());
        return End::kRegular;
    }
    if (!flips.hidden()) return End::kStuck;
    const double volume = testing::clipped_power_cell(sites, weights, *flips.hidden()).volume();
    EXPECT_LT(volume, 1e-12 * sites.lattice().volume() / sites.n_sites());
    return End::kHidden;
}

TEST(PowerFlips, SlowEndRegularOrNameASiteThatIsHidden) {
    std::mt19937_64 random(1);
    std::array<int, 3> n_ends{};
    for (int k = 0; k < 1200; ++k) {
        const Lattice lattice = testing::random_space_lattice(random);
        const Sites sites(lattice, uniform_points(lattice, 1 + k % 20, random()));
        const Eigen::VectorXd weights =
            testing::random_space_weights(sites, 0.15 * (1 + k % 7), random);
        SCOPED_TRACE("input " + std::to_string(k));
        TorusTetrahedra t = periodic_delaunay(sites).tetrahedra;
        const End end = expect_laws(sites, t, weights);
        ++n_ends[std::size_t(end)];
        const testing::SpacePowerMirrors mirrors = testing::space_power_mirrors(sites, weights);
        if (end == End::kRegular) {
            ASSERT_TRUE(mirrors.hidden.empty());
            ASSERT_TRUE(testing::canonical_tetrahedra(t) == mirrors.tetrahedra);
        } else if (end == End::kHidden) {
            ASSERT_FALSE(mirrors.hidden.empty());
        }
        if (HasFatalFailure() || HasNonfatalFailure()) return;
    }
    EXPECT_GT(n_ends[0], 400);
    EXPECT_GT(n_ends[1], 200);
    EXPECT_LT(n_ends[2], 12);
}

// Ties: exact rows, planes, grids and spheres, with equal weights and with weights of few values.
TEST(PowerFlips, BreakTiesAsTheMirrorsDo) {
    std::mt19937_64 random(2);
    int n_regular = 0;
    for (int seed = 0; seed < 12; ++seed) {
        for (const auto& [name, points] : testing::special_coordinates(std::uint64_t(seed))) {
            SCOPED_TRACE(name + " seed " + std::to_string(seed));
            const Sites sites(testing::kCube, points);
            const double h = sites.spacing();
            Eigen::VectorXd weights(sites.n_sites());
            const double unit = std::ldexp(1.0, std::ilogb(h * h) - 3 - seed % 3);
            for (double& w : weights) w = testing::random_integer(random, 0, 1) * unit;
            TorusTetrahedra t = periodic_delaunay(sites).tetrahedra;
            if (expect_laws(sites, t, weights) != End::kRegular) continue;
            ++n_regular;
            const testing::SpacePowerMirrors mirrors = testing::space_power_mirrors(sites, weights);
            if (!mirrors.hidden.empty()) continue;
            ASSERT_TRUE(testing::canonical_tetrahedra(t) == mirrors.tetrahedra);
        }
    }
    EXPECT_GT(n_regular, 80);
}

// The flips need no particular start: here the regular tetrahedra of other weights.
TEST(PowerFlips, ReachTheSameTetrahedraFromAnyStart) {
    std::mt19937_64 random(3);
    int n_same = 0;
    for (int k = 0; k < 150; ++k) {
        const Sites sites = testing::random_space_sites(random).sites;
        if (sites.n_sites() > 60) continue;
        const TorusTetrahedra delaunay = periodic_delaunay(sites).tetrahedra;
        const Eigen::VectorXd weights = testing::random_space_weights(sites, 0.1, random);
        TorusTetrahedra direct = delaunay;
        TorusTetrahedra other = delaunay;
        if (expect_laws(sites, direct, weights) != End::kRegular) continue;
        expect_laws(sites, other, testing::random_space_weights(sites, 0.3, random));
        if (expect_laws(sites, other, weights) != End::kRegular) continue;
        ++n_same;
        ASSERT_EQ(testing::canonical_tetrahedra(direct), testing::canonical_tetrahedra(other));
    }
    EXPECT_GT(n_same, 40);
}

// Law 3.
TEST(PowerFlips, EqualWeightsFlipNothingOfDelaunayTetrahedra) {
    for (const auto& [name, sites] : testing::space_site_families(4)) {
        TorusTetrahedra t = periodic_delaunay(sites).tetrahedra;
        for (const double w : {0.0, 1.0 / 3}) {
            const Eigen::VectorXd weights = Eigen::VectorXd::Constant(sites.n_sites(), w);
            const PowerFlips flips(t, sites.coordinates(), gram_of(sites.reduction().reduced),
                                   weights);
            EXPECT_TRUE(flips.irregular_facets().empty()) << name;
        }
    }
}

}  // namespace
}  // namespace pcvt::space
