#include "mesher/plane/cvt/symmetric_coarse_start.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/cvt_options.hpp"
#include "tests/support/densities.hpp"
#include "tests/support/energy_at.hpp"
#include "tests/support/symmetry.hpp"

namespace pcvt::plane {
namespace {

using testing::expect_symmetric;
using testing::fitting_lattice;

PlaneGroup example(PlaneGroupName name) { return {name, fitting_lattice(name)}; }

OrbitPlan general_plan(const PlaneGroup& group, int n_orbits) {
    return distribute(group, special_positions(group), n_orbits * group.order());
}

double energy_over_bound(const SymmetricSites& sites) {
    return testing::energy_at(sites.sites).value /
           hexagonal_bound(sites.group.lattice().area(), sites.sites.n_sites());
}

/// Delaunay edges shorter than 0.4 h, as a part of the sites.
double share_of_close_pairs(const SymmetricSites& sites) {
    const PeriodicDelaunay delaunay(sites.sites);
    const TorusTriangulation& t = delaunay.triangulation();
    const Lattice& reduced = sites.sites.reduction().reduced;
    const Points& coordinates = sites.sites.coordinates();
    const auto at = [&](const Corner& corner) {
        return Vec2(coordinates.col(corner.site) + Vec2(corner.offset.i, corner.offset.j));
    };
    int n_close = 0;
    for (int h = 0; h < t.n_halfedges(); ++h) {
        const Vec2 way = at(t.corner(TorusTriangulation::next(h))) - at(t.corner(h));
        if (reduced.to_position(way).norm() < 0.4 * sites.sites.spacing()) ++n_close;
    }
    return 0.5 * n_close / sites.sites.n_sites();
}

/// The mean over seeds for 256 orbits in general positions and n_on_mirrors on each mirror.
double mean_share_of_close_pairs(const PlaneGroup& group, int n_on_mirrors, int n_seeds) {
    const SpecialPositions special = special_positions(group);
    const OrbitPlan plan{256, std::vector<int>(special.mirrors.size(), n_on_mirrors),
                         std::vector<bool>(special.centres.size(), false)};
    double sum = 0;
    for (int seed = 1; seed <= n_seeds; ++seed) {
        sum += share_of_close_pairs(*symmetric_coarse_start(group, plan, seed, {}));
    }
    return sum / n_seeds;
}

TEST(SymmetricCoarseStart, HasTheOrbitsOfThePlanInEveryGroup) {
    for (const PlaneGroupRow& row : kPlaneGroups) {
        const PlaneGroup group = example(row.name);
        const SpecialPositions special = special_positions(group);
        for (const bool occupied : {false, true}) {
            for (const int n : {1, 2, 16, 17, 66, 150}) {
                const OrbitPlan plan{n, std::vector<int>(special.mirrors.size(), occupied ? 2 : 0),
                                     std::vector<bool>(special.centres.size(), occupied)};
                const auto start = symmetric_coarse_start(group, plan, 1, {});
                ASSERT_TRUE(start.has_value());
                expect_symmetric(*start, start->sites);
                EXPECT_EQ(start->sites.n_sites(), n_sites(group, special, plan)) << row.word;
                const auto of_freedom = [&start](int freedom) {
                    return std::count_if(start->orbits.begin(), start->orbits.end(),
                                         [=](const SiteOrbit& o) { return o.freedom == freedom; });
                };
                EXPECT_EQ(of_freedom(2), n) << row.word;
                EXPECT_EQ(of_freedom(1), std::ssize(special.mirrors) * (occupied ? 2 : 0));
                EXPECT_EQ(of_freedom(0), occupied ? std::ssize(special.centres) : 0);
            }
        }
    }
}

// Missing or repeated midpoints leave holes or close pairs, whose cells have a large energy.
TEST(SymmetricCoarseStart, SlowIsEvenInEveryGroup) {
    for (const PlaneGroupRow& row : kPlaneGroups) {
        const PlaneGroup group = example(row.name);
        const OrbitPlan plan = general_plan(group, 256);
        // Beside a mirror, levels differ most.
        const bool with_mirrors = !special_positions(group).mirrors.empty();
        for (std::uint64_t seed = 1; seed <= 3; ++seed) {
            const auto start = symmetric_coarse_start(group, plan, seed, {});
            EXPECT_LT(energy_over_bound(*start), with_mirrors ? 1.3 : 1.16) << row.word;
            EXPECT_GT(energy_over_bound(random_sites(group, plan, seed)), 1.5) << row.word;
        }
    }
}

// The limits lie between the shares of the code and those with one fault: 0.0006 and 0.004 where an
// edge round a centre of rotation adds its site twice, 0.019 and 0.038 where a site is added at the
// middle of an edge across a mirror, 0.004 and 0.009 where sites on mirrors are put back wrongly.
TEST(SymmetricCoarseStart, SlowHasFewClosePairs) {
    double round_centres = 0;
    for (const auto name : {PlaneGroupName::kP3, PlaneGroupName::kP4, PlaneGroupName::kP6}) {
        round_centres += mean_share_of_close_pairs(example(name), 0, 8) / 3;
    }
    EXPECT_LT(round_centres, 0.002);
    double across_mirrors = 0;
    int n_groups = 0;
    for (const PlaneGroupRow& row : kPlaneGroups) {
        const PlaneGroup group = example(row.name);
        if (special_positions(group).mirrors.empty()) continue;
        across_mirrors += mean_share_of_close_pairs(group, 0, 4);
        ++n_groups;
    }
    EXPECT_LT(across_mirrors / n_groups, 0.027);
    EXPECT_LT(mean_share_of_close_pairs(example(PlaneGroupName::kP3m1), 12, 8), 0.0065);
}

TEST(SymmetricCoarseStart, SlowLeadsToLowerMinima) {
    CvtOptions options;
    options.run.tolerance = 1e-4;
    for (const PlaneGroupName name :
         {PlaneGroupName::kP2, PlaneGroupName::kPm, PlaneGroupName::kPgg, PlaneGroupName::kP3}) {
        const PlaneGroup group = example(name);
        const OrbitPlan plan = general_plan(group, 1000);
        double random = 0;
        double coarse = 0;
        for (std::uint64_t seed = 1; seed <= 2; ++seed) {
            random += compute_cvt(random_sites(group, plan, seed), options).run.energy;
            const auto start = symmetric_coarse_start(group, plan, seed, {});
            const CvtResult result = compute_cvt(*start, options);
            expect_symmetric(*start, result.delaunay.sites());
            coarse += result.run.energy;
        }
        EXPECT_LT(coarse, random * (1 - 1e-3)) << group.row().word;
    }
}

TEST(SymmetricCoarseStart, FollowsADensity) {
    const PlaneGroup group(PlaneGroupName::kP4m, Lattice::rectangle(1, 1));
    CoarseStartOptions options;
    // One corner of the asymmetric unit is dense.
    options.density = shared_density([](const DensityPoint& p) {
        return std::exp(2 * std::cos(2 * std::numbers::pi * p.u) +
                        2 * std::cos(2 * std::numbers::pi * p.v));
    });
    const auto start = symmetric_coarse_start(group, general_plan(group, 200), 1, options);
    ASSERT_TRUE(start.has_value());
    expect_symmetric(*start, start->sites);
    CvtOptions as_given;
    as_given.run.max_iterations = 0;
    as_given.density = options.density;
    const CvtResult at_start = compute_cvt(*start, as_given);
    EXPECT_LT(at_start.run.energy, 1.3 * at_start.density->expected_energy);
}

TEST(SymmetricCoarseStart, DependsOnTheSeedAndNotOnTheThreadsSlow) {
    const PlaneGroup group = example(PlaneGroupName::kP6m);
    const OrbitPlan plan = general_plan(group, 6000);
    const auto one = symmetric_coarse_start(group, plan, 1, {});
    EXPECT_EQ(one->sites.coordinates(),
              symmetric_coarse_start(group, plan, 1, {{.n_threads = 3}})->sites.coordinates());
    EXPECT_NE(one->sites.coordinates(),
              symmetric_coarse_start(group, plan, 2, {})->sites.coordinates());
}

TEST(SymmetricCoarseStart, StopsWhenCancelled) {
    const PlaneGroup group = example(PlaneGroupName::kPgg);
    CoarseStartOptions options;
    int n_calls = 0;
    options.run.progress = [&](const Progress&) { return ++n_calls < 5; };
    EXPECT_FALSE(symmetric_coarse_start(group, general_plan(group, 300), 1, options).has_value());
    EXPECT_EQ(n_calls, 5);
}

}  // namespace
}  // namespace pcvt::plane
