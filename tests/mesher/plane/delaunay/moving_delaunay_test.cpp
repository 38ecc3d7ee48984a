#include "mesher/plane/delaunay/moving_delaunay.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "tests/support/checked_engine.hpp"
#include "tests/support/lattices.hpp"
#include "tests/support/moves.hpp"
#include "tests/support/special_sites.hpp"

namespace pcvt::plane {
namespace {

using testing::CheckedEngine;
using testing::collapse;
using testing::drift;
using testing::exchange;
using testing::lattices;
using testing::lloyd_move;
using testing::meet;
using testing::normal_move;
using testing::period_jumps;

/// The resolution of the coordinates.
constexpr double kUlp = 0x1p-51;

/// CheckedEngine checks laws 1 and 2, the energy and the number of builds after each move; a test
/// fails where it finds a difference.
#define EXPECT_NO_FAULT(engine) EXPECT_EQ((engine).fault(), "")

CheckedEngine random_engine(const Lattice& lattice, int n, std::uint64_t seed) {
    return CheckedEngine(Sites(lattice, uniform_points(lattice, n, seed)));
}

std::vector<testing::NamedLattice> thin_lattices() {
    return {{"wide", Lattice::rectangle(1000, 1)},
            {"tall", Lattice::rectangle(1, 1000)},
            {"oblique", Lattice({1, 0.3}, {400, 1000})}};
}

void jump_about(CheckedEngine& engine, std::mt19937_64& random) {
    for (const double size : {1e-14, 1e-9, 1e-3, 0.03, 0.3, 1.0, 1e3, 1e-7, 1e-1, 1e12}) {
        const double spacing = engine.delaunay().spacing();
        if (engine.move(normal_move(engine.delaunay(), random, size * spacing))) {
            engine.settle();
        }
    }
    EXPECT_NO_FAULT(engine);
}

TEST(MovingDelaunay, AJumpOfAnySizeEqualsANewBuild) {
    std::mt19937_64 random(1);
    for (const auto& [name, lattice] : lattices()) {
        for (const int n : {1, 2, 3, 4, 5, 6, 7, 8, 40, 300}) {
            SCOPED_TRACE(name + " n = " + std::to_string(n));
            CheckedEngine engine = random_engine(lattice, n, random());
            jump_about(engine, random);
        }
    }
}

TEST(MovingDelaunay, AJumpOfAnySizeEqualsANewBuildOnRandomLattices) {
    std::mt19937_64 random(2);
    for (int k = 0; k < 200; ++k) {
        const Lattice lattice = testing::random_lattice(random);
        SCOPED_TRACE("input " + std::to_string(k));
        CheckedEngine engine = random_engine(lattice, 1 + k % 25, random());
        jump_about(engine, random);
    }
}

TEST(MovingDelaunay, AJumpOfAnySizeEqualsANewBuildOnThinLattices) {
    std::mt19937_64 random(3);
    for (const auto& [name, lattice] : thin_lattices()) {
        for (const int n : {1, 2, 3, 5, 8, 60, 500}) {
            SCOPED_TRACE(name + " n = " + std::to_string(n));
            CheckedEngine engine = random_engine(lattice, n, random());
            jump_about(engine, random);
        }
    }
}

TEST(MovingDelaunay, SitesGatherNearOnePointAndSeparateAgain) {
    std::mt19937_64 random(4);
    for (const auto& [name, lattice] : lattices()) {
        for (const int n : {2, 3, 5, 8, 30, 200}) {
            SCOPED_TRACE(name + " n = " + std::to_string(n));
            CheckedEngine engine = random_engine(lattice, n, random());
            for (const double factor : {0.1, 1e-3, 0.01, 30.0, 1e-2, 1e-6}) {
                const Vec2 place(0.3, 0);
                if (engine.move(collapse(engine.delaunay(), {random}, place, factor))) {
                    engine.settle();
                }
            }
            jump_about(engine, random);
        }
    }
}

TEST(MovingDelaunay, TwoSitesExchangePositionsOrPassThroughEachOther) {
    std::mt19937_64 random(5);
    for (const auto& [name, lattice] : lattices()) {
        for (const int n : {2, 3, 4, 8, 100}) {
            SCOPED_TRACE(name + " n = " + std::to_string(n));
            CheckedEngine engine = random_engine(lattice, n, random());
            for (int k = 0; k < 8; ++k) {
                const auto site = static_cast<SiteId>(k % n);
                const auto other = static_cast<SiteId>((k + 1) % n);
                engine.move(exchange(engine.delaunay(), site, other));
                engine.settle();
                engine.move(meet(engine.delaunay(), site, other, 2.0 + k));
                engine.settle();
            }
            EXPECT_NO_FAULT(engine);
        }
    }
}

TEST(MovingDelaunay, SitesDriftOverTheSeamForSeveralPeriods) {
    std::mt19937_64 random(6);
    for (const auto& [name, lattice] : lattices()) {
        for (const int n : {1, 2, 5, 60}) {
            SCOPED_TRACE(name + " n = " + std::to_string(n));
            CheckedEngine engine = random_engine(lattice, n, random());
            for (int k = 0; k < 25; ++k) {
                const Vec2 periods(0.37, k % 3 == 0 ? -1.3 : -0.29);
                const double noise = 0.1 * engine.delaunay().spacing();
                if (engine.move(drift(engine.delaunay(), periods) +
                                normal_move(engine.delaunay(), random, noise))) {
                    engine.settle();
                }
                engine.move(period_jumps(engine.delaunay(), random));
                engine.step_back();
            }
            EXPECT_NO_FAULT(engine);
        }
    }
}

// The engine checks that coordinates stay in range; a step back or a jump would bring them back
// into it.
TEST(MovingDelaunay, SitesDriftFarByShortSteps) {
    for (const auto& [name, lattice] : lattices()) {
        CheckedEngine engine = random_engine(lattice, 40, 5);
        for (int k = 0; k < 25; ++k) {
            engine.move(drift(engine.delaunay(), {0.37, -0.29}));
            engine.settle();
        }
        EXPECT_NO_FAULT(engine) << name;
    }
}

TEST(MovingDelaunay, SitesThatCrossTheSeamTogetherNeedNoBuild) {
    std::mt19937_64 random(16);
    for (const auto& [name, lattice] : lattices()) {
        CheckedEngine engine = random_engine(lattice, 40, random());
        for (int k = 0; k < 20; ++k) {
            engine.move(drift(engine.delaunay(), {2.45, -0.3}));
            engine.step_back();
            engine.move(drift(engine.delaunay(), {0.37, -0.29}));
            engine.settle();
            engine.move(period_jumps(engine.delaunay(), random));
            engine.settle();
        }
        EXPECT_EQ(engine.tally().rebuilds, 0) << name;
        EXPECT_NO_FAULT(engine) << name;
    }
}

// Moves are rounded to single precision; the sites reach their targets after the third move.
TEST(MovingDelaunay, SitesThatMeetAreReportedAndUndone) {
    std::mt19937_64 random(7);
    for (const auto& [name, lattice] : lattices()) {
        for (const int n : {2, 3, 5, 8, 50}) {
            SCOPED_TRACE(name + " n = " + std::to_string(n));
            CheckedEngine engine = random_engine(lattice, n, random());
            for (int k = 0; k < 4; ++k) {
                if (engine.move(meet(engine.delaunay(), 0, 1))) engine.settle();
            }
            EXPECT_GE(engine.tally().undefined, 1);
            jump_about(engine, random);
            for (int k = 0; k < 5; ++k) {
                if (engine.move(collapse(engine.delaunay(), {random}, {0.5, 1}, 0))) {
                    engine.settle();
                }
            }
            EXPECT_GE(engine.tally().undefined, 2);
            jump_about(engine, random);
        }
    }
}

// Gathering sites are partly repaired before two of them turn out to coincide: the triangulation is
// then Delaunay at neither position.
TEST(MovingDelaunay, AStepBackFromCoincidentSitesRestoresAHalfRepairedTriangulation) {
    std::mt19937_64 random(15);
    for (int k = 0; k < 150; ++k) {
        SCOPED_TRACE("input " + std::to_string(k));
        CheckedEngine engine = random_engine(lattices()[k % 10].lattice, 4 + k % 13, random());
        for (int m = 0; m < 8 && engine.fault().empty(); ++m) {
            const double share = m < 2 ? 1 : 0.7;
            if (engine.move(collapse(engine.delaunay(), {random, share}, {0.3, 0.4}, 0))) {
                engine.settle();
            }
        }
        EXPECT_NO_FAULT(engine);
    }
}

TEST(MovingDelaunay, AStepThatIsNotFiniteIsRejectedAndMovesNothing) {
    std::mt19937_64 random(8);
    for (const float wrong :
         {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
        for (const int n : {1, 2, 7, 100}) {
            CheckedEngine engine = random_engine(Lattice({1, 0}, {0.37, 0.81}), n, 1);
            Eigen::VectorXf direction = normal_move(engine.delaunay(), random, 1);
            direction[direction.size() - 1] = wrong;
            EXPECT_FALSE(engine.move(direction));
            EXPECT_FALSE(engine.move(normal_move(engine.delaunay(), random, 1), wrong));
            jump_about(engine, random);
        }
    }
}

TEST(MovingDelaunay, RejectedTrialsLeaveNoTrace) {
    std::mt19937_64 random(9);
    for (const auto& [name, lattice] : lattices()) {
        CheckedEngine engine = random_engine(lattice, 30, random());
        for (const double size : {1e-6, 0.01, 0.3, 2.0, 1e5}) {
            const double spacing = engine.delaunay().spacing();
            const auto direction = normal_move(engine.delaunay(), random, size * spacing);
            for (const double t : {1.0, 0.3, 0.1}) {
                if (engine.move(direction, t)) engine.step_back();
            }
        }
        EXPECT_NO_FAULT(engine) << name;
    }
}

/// Moves each coordinate by one unit in the last place up, down, or not at all.
Eigen::VectorXf ulp_move(const MovingDelaunay& delaunay, std::mt19937_64& random) {
    Eigen::VectorXf move(2 * delaunay.n_sites());
    for (SiteId s = 0; s < delaunay.n_sites(); ++s) {
        const double i = double(random() % 3) - 1;
        const double j = double(random() % 3) - 1;
        move.segment<2>(2 * s) = delaunay.frame().to_position({i * kUlp, j * kUlp}).cast<float>();
    }
    return move;
}

TEST(MovingDelaunay, TiesAndNearTiesAreDecidedExactly) {
    std::mt19937_64 random(10);
    for (const auto& [name, sites] : testing::special_sites()) {
        CheckedEngine engine(sites);
        for (int k = 0; k < 6; ++k) {
            engine.move(ulp_move(engine.delaunay(), random));
            engine.settle();
        }
        EXPECT_NO_FAULT(engine) << name;
    }
}

/// The triangular lattice without every 16th of its points: rings of six points round the holes.
Sites hexagons() {
    const Lattice lattice({1, 0}, {0.5, std::sqrt(0.75)});
    Points points(2, 60);
    for (int k = 0, s = 0; k < 64; ++k) {
        if (k % 4 != 0 || k / 8 % 4 != 0) {
            points.col(s++) = lattice.to_position({k % 8 / 8.0, k / 8 / 8.0});
        }
    }
    return {lattice, points};
}

TEST(MovingDelaunay, TheFilterFailsOnExactGridsAndOnHexagonsUpToOneUlp) {
    std::mt19937_64 random(11);
    const Sites grid = testing::grid_sites(Lattice::rectangle(1, 1), 8, 8, 0, 0);
    for (const Sites& sites : {grid, hexagons()}) {
        CheckedEngine engine(sites);
        EXPECT_GT(engine.tally().exact, 10);
        for (int k = 0; k < 20; ++k) {
            const auto before = engine.tally();
            engine.move(ulp_move(engine.delaunay(), random));
            // Occasionally one ulp breaks the tie, and the filter does not detect it.
            EXPECT_GT(engine.tally().exact, before.exact);
            EXPECT_GT(engine.tally().flips, before.flips);
            engine.step_back();
        }
        EXPECT_EQ(engine.tally().rebuilds, 0);
        EXPECT_NO_FAULT(engine);
    }
}

TEST(MovingDelaunay, TheFilterRarelyFailsOnRandomSites) {
    std::mt19937_64 random(12);
    CheckedEngine engine = random_engine(Lattice({1, 0}, {0.37, 0.81}), 1000, 1);
    for (int k = 0; k < 10; ++k) {
        engine.move(normal_move(engine.delaunay(), random, 0.1));
        engine.settle();
    }
    EXPECT_GT(engine.tally().predicates, 10000);
    EXPECT_LE(engine.tally().exact, 10);
    EXPECT_NO_FAULT(engine);
}

/// Moves two consecutive sites by large fractions of the periods.
Eigen::VectorXf jump_of_two(SiteId n_sites, std::mt19937_64& random) {
    Eigen::VectorXf jump = Eigen::VectorXf::Zero(2 * n_sites);
    jump.segment<4>(2 * (random() % (n_sites - 1))) << 0.6f, 0.4f, -0.3f, 0.6f;
    return jump;
}

TEST(MovingDelaunay, LloydStepsAndJumpsOfFewSitesNeedNoBuild) {
    std::mt19937_64 random(13);
    CheckedEngine engine = random_engine(Lattice::rectangle(1, 1), 1000, 1);
    for (int k = 0; k < 20; ++k) {
        engine.move(lloyd_move(engine.delaunay(), engine.energy()));
        engine.settle();
        if (k >= 5) engine.move(jump_of_two(1000, random));
        engine.settle();
    }
    EXPECT_EQ(engine.tally().rebuilds, 0);
    EXPECT_GE(engine.tally().local_repairs, 5);
    EXPECT_NO_FAULT(engine);
}

// A local repair may get stuck, but rarely does.
TEST(MovingDelaunay, AStepBackAfterAJumpOfFewSitesRarelyNeedsABuild) {
    std::mt19937_64 random(17);
    CheckedEngine engine = random_engine(Lattice::rectangle(1, 1), 1000, 1);
    for (int k = 0; k < 10; ++k) {
        ASSERT_TRUE(engine.move(jump_of_two(1000, random)));
        engine.step_back();
    }
    EXPECT_LE(engine.tally().rebuilds, 2);
    EXPECT_GE(engine.tally().local_repairs, 15);
    EXPECT_NO_FAULT(engine);
}

TEST(MovingDelaunay, ReleasesTheSitesInTheCallersOrder) {
    for (const auto& [name, lattice] : lattices()) {
        const Sites sites(lattice, uniform_points(lattice, 50, 1));
        EXPECT_EQ(MovingDelaunay(sites).release().first.coordinates(), sites.coordinates());
        std::mt19937_64 random(14);
        CheckedEngine engine(sites);
        if (engine.move(normal_move(engine.delaunay(), random, 3))) engine.settle();
        engine.move(drift(engine.delaunay(), {0.4, 0.4}));
        engine.release();
        EXPECT_NO_FAULT(engine) << name;
    }
}

}  // namespace
}  // namespace pcvt::plane
