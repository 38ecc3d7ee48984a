#include "mesher/plane/delaunay/delaunay_patch.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <numeric>
#include <random>
#include <set>

#include "mesher/plane/delaunay/periodic_delaunay.hpp"
#include "tests/support/lattices.hpp"

namespace pcvt::plane {
namespace {

/// For each site the number of edges to the nearest of some sites, by relaxation over all edges.
std::vector<int> distances(const TorusTriangulation& t, const std::vector<SiteId>& first) {
    std::vector<int> distance(std::size_t(t.n_sites()), t.n_sites());
    for (const SiteId s : first) distance[s] = 0;
    for (int pass = 0; pass < t.n_sites(); ++pass) {
        bool changed = false;
        for (int h = 0; h < t.n_halfedges(); ++h) {
            int& to = distance[t.corner(TorusTriangulation::next(h)).site];
            const int through = distance[t.corner(h).site] + 1;
            changed |= through < to;
            to = std::min(to, through);
        }
        if (!changed) break;
    }
    return distance;
}

struct Problem {
    MovingDelaunay whole;
    std::vector<SiteId> first;
    std::vector<bool> is_fixed;
    int n_rings;
};

Problem random_problem(const Lattice& lattice, int n, std::mt19937_64& random) {
    Problem problem{MovingDelaunay(Sites(lattice, uniform_points(lattice, n, random()))),
                    {},
                    std::vector<bool>(std::size_t(n)),
                    int(random() % 4)};
    for (SiteId s = 0; s < n; ++s) {
        if (random() % 60 == 0 || s == n / 2) problem.first.push_back(s);
        problem.is_fixed[s] = random() % 5 == 0;
    }
    std::shuffle(problem.first.begin(), problem.first.end(), random);
    return problem;
}

PatchPlans plans_of(const Problem& p) {
    return {p.whole.triangulation(), p.first, p.is_fixed, p.n_rings};
}

int least_distance(const TorusTriangulation& t, int triangle, const std::vector<int>& distance) {
    int least = t.n_sites();
    for (int k = 0; k < 3; ++k) {
        least = std::min(least, distance[t.corner(3 * triangle + k).site]);
    }
    return least;
}

void expect_rings(const Problem& p) {
    const TorusTriangulation& t = p.whole.triangulation();
    const std::vector<int> distance = distances(t, p.first);
    const PatchPlans plans = plans_of(p);
    std::vector<int> patch_of(std::size_t(t.n_triangles()), -1);
    std::set<SiteId> moving;
    for (int k = 0; k < plans.n_patches(); ++k) {
        for (const int triangle : plans.patch(k).triangles) {
            EXPECT_EQ(patch_of[triangle], -1) << "a triangle of two patches";
            patch_of[triangle] = k;
        }
        for (const SiteId s : plans.patch(k).moving) EXPECT_TRUE(moving.insert(s).second);
    }
    EXPECT_EQ(plans.n_moving(), int(moving.size()));
    for (SiteId s = 0; s < t.n_sites(); ++s) {
        EXPECT_EQ(moving.count(s) == 1, distance[s] <= p.n_rings && !p.is_fixed[s]);
    }
    for (int triangle = 0; triangle < t.n_triangles(); ++triangle) {
        EXPECT_EQ(patch_of[triangle] >= 0, least_distance(t, triangle, distance) <= p.n_rings + 1);
    }
    // Adjacent triangles are in one patch, or one of them is in none.
    for (int h = 0; h < t.n_halfedges(); ++h) {
        const int here = patch_of[h / 3];
        const int beyond = patch_of[t.opposite(h) / 3];
        EXPECT_TRUE(here == beyond || here < 0 || beyond < 0);
    }
}

TEST(PatchPlans, HoldTheRingsRoundTheFirstSitesInDisjointPatches) {
    std::mt19937_64 random(7);
    for (const auto& [name, lattice] : testing::lattices()) {
        for (const int n : {1, 2, 3, 4, 5, 6, 7, 8, 60, 700}) {
            SCOPED_TRACE(name + " n = " + std::to_string(n));
            expect_rings(random_problem(lattice, n, random));
        }
    }
}

TEST(PatchPlans, OfFarSitesAreSeveralPatches) {
    const Lattice unit = Lattice::rectangle(1, 1);
    const MovingDelaunay whole(Sites(unit, uniform_points(unit, 3000, 1)));
    const PatchPlans plans(whole.triangulation(), {10, 1500}, {}, 2);
    EXPECT_EQ(plans.n_patches(), 2);
    const PatchPlans joined(whole.triangulation(), {10, 1500}, {}, 40);
    EXPECT_EQ(joined.n_patches(), 1);
}

bool has_inverted(const DelaunayPatch& patch) {
    const TorusTriangulation& t = patch.triangulation();
    const auto at = [&](int h) {
        return image(patch.coordinates(), t.corner(h).site, t.corner(h).offset);
    };
    for (int h = 0; h < t.n_halfedges(); h += 3) {
        if (orientation(at(h), at(h + 1), at(h + 2)) <= 0) return true;
    }
    return false;
}

/// Moves the sites of each patch at random, in several steps, and takes them over.
void move_patches(Problem& p, std::mt19937_64& random) {
    const PatchPlans plans = plans_of(p);
    Workers workers(1);
    std::normal_distribution<float> normal(0, 0.05F * float(p.whole.spacing()));
    for (int k = 0; k < plans.n_patches(); ++k) {
        DelaunayPatch patch(p.whole, plans, k);
        Eigen::VectorXf direction(2 * patch.n_sites());
        for (int step = 0; step < 4; ++step) {
            for (float& x : direction) x = normal(random);
            if (!patch.step(direction, 1, workers)) continue;
            if (has_inverted(patch)) {
                patch.step_back();
                continue;
            }
            std::vector<int> suspects(std::size_t(patch.triangulation().n_halfedges()));
            std::iota(suspects.begin(), suspects.end(), 0);
            patch.flip(suspects);
            patch.settle();
        }
        p.whole.adopt(patch.moving(), patch.coordinates(), patch.flips());
    }
}

/// Every edge is locally Delaunay after flips at the borders of the patches; throws otherwise.
void expect_restorable(MovingDelaunay whole) {
    Suspects all;
    for (int h = 0; h < whole.triangulation().n_halfedges(); ++h) all.halfedges.push_back(h);
    whole.flip(all, nullptr);
    auto [sites, triangulation] = whole.release();
    EXPECT_NO_THROW(PeriodicDelaunay(std::move(sites), std::move(triangulation)));
}

TEST(DelaunayPatch, MovesAndFlipsCarryOverToTheWholeTriangulation) {
    std::mt19937_64 random(3);
    std::int64_t n_flips = 0;
    for (const auto& [name, lattice] : testing::lattices()) {
        for (const int n : {1, 2, 3, 5, 8, 60, 700}) {
            SCOPED_TRACE(name + " n = " + std::to_string(n));
            Problem p = random_problem(lattice, n, random);
            const Points before = p.whole.coordinates();
            const std::vector<int> distance = distances(p.whole.triangulation(), p.first);
            move_patches(p, random);
            n_flips += p.whole.counts().n_flips;
            for (SiteId s = 0; s < n; ++s) {
                if (distance[s] <= p.n_rings && !p.is_fixed[s]) continue;
                EXPECT_EQ(p.whole.coordinates().col(s), before.col(s));
            }
            expect_restorable(std::move(p.whole));
        }
    }
    EXPECT_GT(n_flips, 300);
}

TEST(DelaunayPatch, RefusesAStepThatIsNotFinite) {
    const Lattice unit = Lattice::rectangle(1, 1);
    const MovingDelaunay whole(Sites(unit, uniform_points(unit, 200, 1)));
    const PatchPlans plans(whole.triangulation(), {17}, {}, 2);
    DelaunayPatch patch(whole, plans, 0);
    const Points before = patch.coordinates();
    Workers workers(1);
    Eigen::VectorXf direction = Eigen::VectorXf::Constant(2 * patch.n_sites(), 0.1F);
    direction[3] = std::numeric_limits<float>::infinity();
    EXPECT_FALSE(patch.step(direction, 1, workers));
    EXPECT_EQ(patch.coordinates(), before);
    EXPECT_TRUE(patch.settled());
}

}  // namespace
}  // namespace pcvt::plane
