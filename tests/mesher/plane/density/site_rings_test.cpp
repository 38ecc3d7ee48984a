#include "mesher/plane/density/site_rings.hpp"

#include <gtest/gtest.h>

#include "tests/support/lattices.hpp"
#include "tests/support/moves.hpp"

namespace pcvt::plane {
namespace {

/// The neighbours of a site by a walk round it, as the least possible sequence: where a site has
/// one neighbour twice, a ring may begin at either.
std::vector<SiteId> walked(const SiteRings& rings, const TorusTriangulation& t, SiteId site) {
    std::vector<SiteId> round;
    rings.go_round(site, [&](int h) {
        EXPECT_EQ(t.corner_sites()[h], site);
        round.push_back(t.corner_sites()[TorusTriangulation::next(h)]);
    });
    EXPECT_EQ(round.front(), *std::min_element(round.begin(), round.end()));
    std::vector<SiteId> least = round;
    for (std::size_t k = 0; k < round.size(); ++k) {
        std::rotate(round.begin(), round.begin() + 1, round.end());
        least = std::min(least, round);
    }
    return least;
}

/// Expects that the rings equal those of a new object.
void expect_like_new(const SiteRings& rings, const MovingDelaunay& delaunay, Workers& workers) {
    SiteRings created(delaunay, workers);
    created.update();
    const TorusTriangulation& t = delaunay.triangulation();
    for (SiteId s = 0; s < delaunay.n_sites(); ++s) {
        const std::vector<SiteId> expected = walked(created, t, s);
        ASSERT_EQ(walked(rings, t, s), expected);
        ASSERT_EQ(rings[s].length, created[s].length);
        std::vector<SiteId> walked_neighbours;
        rings.go_round(s, [&](int h) { walked_neighbours.push_back(t.corner_sites()[t.next(h)]); });
        for (int k = 0; k < rings[s].length; ++k)
            ASSERT_EQ(rings[s].neighbours[k], walked_neighbours[k]);
    }
}

// Law 1 after flips, repairs, builds, steps back, and moves by whole periods.
TEST(SiteRings, EqualTheRingsOfANewObjectAfterAnyMoves) {
    std::mt19937_64 random(3);
    for (const auto& [name, lattice] : testing::lattices()) {
        for (const int n : {1, 2, 5, 40, 300}) {
            SCOPED_TRACE(name + " n = " + std::to_string(n));
            MovingDelaunay delaunay(Sites(lattice, uniform_points(lattice, n, random())));
            Workers workers(2);
            EnergyPass pass(delaunay, workers);
            Energy energy;
            ASSERT_TRUE(pass.evaluate(energy));
            SiteRings rings(delaunay, workers);
            for (int k = 0; k < 2 * testing::kMoveKinds; ++k) {
                const auto move =
                    testing::any_move(delaunay, energy, random, k % testing::kMoveKinds);
                if (delaunay.step(move.direction, 1, workers) && pass.evaluate(energy)) {
                    rings.update();
                    expect_like_new(rings, delaunay, workers);
                    if (k % 2 == 0) delaunay.settle();
                }
                if (!delaunay.settled()) {
                    delaunay.step_back();
                    ASSERT_TRUE(pass.evaluate(energy));
                }
                rings.update();
                expect_like_new(rings, delaunay, workers);
            }
        }
    }
}

// Law 1 where nothing flips, but sites are wrapped and triangles get offsets.
TEST(SiteRings, EqualTheRingsOfANewObjectAfterADriftOfAllSites) {
    const Lattice lattice({1, 0}, {0.37, 0.81});
    MovingDelaunay delaunay(Sites(lattice, uniform_points(lattice, 60, 1)));
    Workers workers(1);
    EnergyPass pass(delaunay, workers);
    Energy energy;
    SiteRings rings(delaunay, workers);
    for (int k = 0; k < 30; ++k) {
        const Eigen::VectorXf drift = testing::drift(delaunay, {0.3, -0.2});
        ASSERT_TRUE(delaunay.step(drift, 1, workers));
        ASSERT_TRUE(pass.evaluate(energy));
        delaunay.settle();
        rings.update();
        expect_like_new(rings, delaunay, workers);
    }
}

TEST(SiteRings, AreCompleteAwayFromTheSeam) {
    const Lattice lattice = Lattice::rectangle(1, 1);
    MovingDelaunay delaunay(Sites(lattice, uniform_points(lattice, 2000, 1)));
    Workers workers(1);
    SiteRings rings(delaunay, workers);
    rings.update();
    int n_complete = 0;
    for (SiteId s = 0; s < 2000; ++s) n_complete += rings[s].length > 0;
    EXPECT_GT(n_complete, 1600);
}

}  // namespace
}  // namespace pcvt::plane
