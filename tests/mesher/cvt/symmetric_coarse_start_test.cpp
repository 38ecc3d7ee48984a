#include "mesher/cvt/symmetric_coarse_start.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/densities.hpp"
#include "tests/support/energy_at.hpp"
#include "tests/support/symmetry.hpp"

namespace pcvt {
namespace {

using testing::expect_symmetric;
using testing::fitting_lattice;

CoarseStartOptions seeded(std::uint64_t seed, int n_threads = 1) {
    return {.seed = seed, .n_threads = n_threads, .density = {}, .progress = {}};
}

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
        if (reduced.to_plane(way).norm() < 0.4 * sites.sites.spacing()) ++n_close;
    }
    return 0.5 * n_close / sites.sites.n_sites();
}

TEST(SymmetricCoarseStart, HasTheOrbitsOfThePlanInEveryGroup) {
    for (const PlaneGroupRow& row : kPlaneGroups) {
        const PlaneGroup group = example(row.name);
        const SpecialPositions special = special_positions(group);
        for (const bool occupied : {false, true}) {
            for (const int n : {1, 2, 16, 17, 66, 150}) {
                const OrbitPlan plan{n, std::vector<int>(special.mirrors.size(), occupied ? 2 : 0),
                                     std::vector<bool>(special.centres.size(), occupied)};
                const auto start = symmetric_coarse_start(group, plan, seeded(1));
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
TEST(SymmetricCoarseStart, IsEvenInEveryGroup) {
    for (const PlaneGroupRow& row : kPlaneGroups) {
        const PlaneGroup group = example(row.name);
        const OrbitPlan plan = general_plan(group, 256);
        // Beside a mirror, levels differ most.
        const bool with_mirrors = !special_positions(group).mirrors.empty();
        for (std::uint64_t seed = 1; seed <= 3; ++seed) {
            const auto start = symmetric_coarse_start(group, plan, seeded(seed));
            EXPECT_LT(energy_over_bound(*start), with_mirrors ? 1.3 : 1.16) << row.word;
            EXPECT_GT(energy_over_bound(random_sites(group, plan, seed)), 1.5) << row.word;
        }
    }
}

// A site that is added twice, or at a centre instead of beside it, has a neighbour as near as two
// shakes; so has a site that is put back to a wrong place on its mirror.
TEST(SymmetricCoarseStart, HasFewClosePairsInEveryGroup) {
    for (const PlaneGroupRow& row : kPlaneGroups) {
        const PlaneGroup group = example(row.name);
        const SpecialPositions special = special_positions(group);
        for (const int n_on_mirrors : {0, 12}) {
            if (n_on_mirrors > 0 && special.mirrors.empty()) continue;
            OrbitPlan plan = general_plan(group, 256);
            plan.n_general = 256;
            std::fill(plan.on_mirrors.begin(), plan.on_mirrors.end(), n_on_mirrors);
            double share = 0;
            for (std::uint64_t seed = 1; seed <= 4; ++seed) {
                share += share_of_close_pairs(*symmetric_coarse_start(group, plan, seeded(seed))) / 4;
            }
            std::printf("%s %d %.4f\n", std::string(row.word).c_str(), n_on_mirrors, share);
        }
    }
}

TEST(SymmetricCoarseStart, LeadsToLowerMinima) {
    CvtOptions options;
    options.tolerance = 1e-4;
    for (const PlaneGroupName name :
         {PlaneGroupName::kP2, PlaneGroupName::kPm, PlaneGroupName::kPgg, PlaneGroupName::kP3}) {
        const PlaneGroup group = example(name);
        const OrbitPlan plan = general_plan(group, 1000);
        double random = 0;
        double coarse = 0;
        for (std::uint64_t seed = 1; seed <= 2; ++seed) {
            random += compute_cvt(random_sites(group, plan, seed), options).run.energy;
            const auto start = symmetric_coarse_start(group, plan, seeded(seed));
            const CvtResult result = compute_cvt(*start, options);
            expect_symmetric(*start, result.delaunay.sites());
            coarse += result.run.energy;
        }
        EXPECT_LT(coarse, random * (1 - 1e-3)) << group.row().word;
    }
}

TEST(SymmetricCoarseStart, FollowsADensity) {
    const PlaneGroup group(PlaneGroupName::kP4m, Lattice::rectangle(1, 1));
    CoarseStartOptions options = seeded(1);
    // One corner of the asymmetric unit is dense.
    options.density = shared_density([](const DensityPoint& p) {
        return std::exp(2 * std::cos(2 * std::numbers::pi * p.u) +
                        2 * std::cos(2 * std::numbers::pi * p.v));
    });
    const auto start = symmetric_coarse_start(group, general_plan(group, 200), options);
    ASSERT_TRUE(start.has_value());
    expect_symmetric(*start, start->sites);
    CvtOptions run;
    run.density = options.density;
    run.max_iterations = 0;
    const CvtResult at_start = compute_cvt(*start, run);
    EXPECT_LT(at_start.run.energy, 1.3 * at_start.density->expected_energy);
}

TEST(SymmetricCoarseStart, DependsOnTheSeedAndNotOnTheThreads) {
    const PlaneGroup group = example(PlaneGroupName::kP6m);
    const OrbitPlan plan = general_plan(group, 6000);
    const auto one = symmetric_coarse_start(group, plan, seeded(1));
    EXPECT_EQ(one->sites.coordinates(),
              symmetric_coarse_start(group, plan, seeded(1, 3))->sites.coordinates());
    EXPECT_NE(one->sites.coordinates(),
              symmetric_coarse_start(group, plan, seeded(2))->sites.coordinates());
}

TEST(SymmetricCoarseStart, StopsWhenCancelled) {
    const PlaneGroup group = example(PlaneGroupName::kPgg);
    CoarseStartOptions options = seeded(1);
    int n_calls = 0;
    options.progress = [&](const Progress&) { return ++n_calls < 5; };
    EXPECT_FALSE(symmetric_coarse_start(group, general_plan(group, 300), options).has_value());
    EXPECT_EQ(n_calls, 5);
}

}  // namespace
}  // namespace pcvt
