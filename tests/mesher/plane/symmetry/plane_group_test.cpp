#include "mesher/plane/symmetry/plane_group.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "mesher/base/error.hpp"
#include "mesher/plane/symmetry/special_positions.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/symmetry.hpp"

namespace pcvt::plane {
namespace {

using ::testing::HasSubstr;

/// The entries of the International Tables: the order of the group with its centring, centres of
/// rotation as (order, number a period), and the number of orbits of mirrors.
struct Published {
    PlaneGroupName name;
    int order;
    std::vector<std::pair<int, int>> centres;
    std::size_t n_mirrors;
};
const std::vector<Published> kPublished{
    {PlaneGroupName::kP1, 1, {}, 0},
    {PlaneGroupName::kP2, 2, {{2, 1}, {2, 1}, {2, 1}, {2, 1}}, 0},
    {PlaneGroupName::kPm, 2, {}, 2},
    {PlaneGroupName::kPg, 2, {}, 0},
    {PlaneGroupName::kCm, 4, {}, 1},
    {PlaneGroupName::kPmm, 4, {{2, 1}, {2, 1}, {2, 1}, {2, 1}}, 4},
    {PlaneGroupName::kPmg, 4, {{2, 2}, {2, 2}}, 1},
    {PlaneGroupName::kPgg, 4, {{2, 2}, {2, 2}}, 0},
    {PlaneGroupName::kCmm, 8, {{2, 2}, {2, 2}, {2, 4}}, 2},
    {PlaneGroupName::kP4, 4, {{4, 1}, {4, 1}, {2, 2}}, 0},
    {PlaneGroupName::kP4m, 8, {{4, 1}, {4, 1}, {2, 2}}, 3},
    {PlaneGroupName::kP4g, 8, {{4, 2}, {2, 2}}, 1},
    {PlaneGroupName::kP3, 3, {{3, 1}, {3, 1}, {3, 1}}, 0},
    {PlaneGroupName::kP3m1, 6, {{3, 1}, {3, 1}, {3, 1}}, 1},
    {PlaneGroupName::kP31m, 6, {{3, 1}, {3, 2}}, 1},
    {PlaneGroupName::kP6, 6, {{6, 1}, {3, 2}, {2, 3}}, 0},
    {PlaneGroupName::kP6m, 12, {{6, 1}, {3, 2}, {2, 3}}, 2}};

/// The same lattice by other bases and in other places.
std::vector<Lattice> lattices_of(PlaneGroupName name) {
    const Lattice one = testing::fitting_lattice(name);
    std::vector<Lattice> all{one, {one.b(), one.a()}, {-one.a(), one.b()}, example_lattice(name)};
    if (plane_group_row(name).system == LatticeSystem::kRectangular) {
        all.push_back(Lattice::rectangle(200, 1));
        all.push_back(Lattice::rectangle(1e-6, 3e-6));
    }
    if (name == PlaneGroupName::kP2) all.push_back(Lattice({1, 0}, {7, 1}));
    return all;
}

bool contains(std::span<const LatticeIsometry> group, const LatticeIsometry& g) {
    return std::find(group.begin(), group.end(), g) != group.end();
}

// Laws (1) and (2).
TEST(PlaneGroup, IsClosedAndKeepsTheGramMatrix) {
    for (const Published& published : kPublished) {
        for (const Lattice& lattice : lattices_of(published.name)) {
            for (const MirrorAxis axis : {MirrorAxis::kAlongA, MirrorAxis::kAlongB}) {
                const PlaneGroup group(published.name, lattice, axis);
                ASSERT_EQ(group.order(), published.order) << group.row().word;
                EXPECT_EQ(group.operations().front(), LatticeIsometry{});
                const Lattice& reduced = group.reduction().reduced;
                for (const LatticeIsometry& g : group.operations()) {
                    for (const LatticeIsometry& h : group.operations()) {
                        EXPECT_TRUE(contains(group.operations(), composed(g, h)));
                    }
                    for (const Vec2& u : {Vec2(1, 0), Vec2(0, 1), Vec2(1, 1)}) {
                        const Vec2 turned = g(u) - g(Vec2(0, 0));
                        EXPECT_NEAR(
                            reduced.to_position(turned).norm() / reduced.to_position(u).norm(), 1,
                            1e-12);
                    }
                }
            }
        }
    }
}

/// The same map of the plane in both bases.
TEST(PlaneGroup, ActsAlikeInTheReducedBasis) {
    for (const Published& published : kPublished) {
        for (const Lattice& lattice : lattices_of(published.name)) {
            const PlaneGroup group(published.name, lattice);
            const Vec2 p = lattice.to_position({0.123, 0.456});
            for (int k = 0; k < group.order(); ++k) {
                const Vec2 given =
                    lattice.to_position(group.given_operations()[k](lattice.to_lattice(p)));
                const Lattice& reduced = group.reduction().reduced;
                const Vec2 other =
                    reduced.to_position(group.operations()[k](reduced.to_lattice(p)));
                const Vec2 periods = lattice.to_lattice(given - other);
                EXPECT_LT((periods.array() - periods.array().round()).abs().maxCoeff(), 1e-9)
                    << published.order << " " << group.row().word;
            }
        }
    }
}

TEST(PlaneGroup, HasThePublishedSpecialPositions) {
    for (const Published& published : kPublished) {
        for (const Lattice& lattice : lattices_of(published.name)) {
            const PlaneGroup group(published.name, lattice);
            const SpecialPositions special = special_positions(group);
            std::vector<std::pair<int, int>> centres;
            for (const auto& centre : special.centres) {
                centres.emplace_back(centre.order, centre.n_sites);
            }
            EXPECT_EQ(centres, published.centres) << group.row().word;
            EXPECT_EQ(special.mirrors.size(), published.n_mirrors) << group.row().word;
        }
    }
}

TEST(PlaneGroup, OfAChannelMirrorsInItsWalls) {
    const PlaneGroup channel(PlaneGroupName::kPm, Lattice::rectangle(3, 2));
    EXPECT_EQ(channel.given_operations()[1], (LatticeIsometry{{1, 0, 0, -1}, {0, 0}}));
    const PlaneGroup upright(PlaneGroupName::kPm, Lattice::rectangle(3, 2), MirrorAxis::kAlongB);
    EXPECT_EQ(upright.given_operations()[1], (LatticeIsometry{{-1, 0, 0, 1}, {0, 0}}));
}

std::string refusal(PlaneGroupName name, const Lattice& lattice) {
    return testing::refusal_of([&] { const PlaneGroup group(name, lattice); });
}

TEST(PlaneGroup, NamesTheLatticesThatFit) {
    const Lattice oblique({1, 0}, {0.37, 0.81});
    const Lattice nearly_square = Lattice::rectangle(1, 1 + 1e-11);
    EXPECT_THAT(refusal(PlaneGroupName::kPm, oblique), HasSubstr("it fits rectangles"));
    EXPECT_THAT(refusal(PlaneGroupName::kCmm, Lattice({1, 0}, {0.5, 0.9})),
                HasSubstr("rectangles"));
    EXPECT_THAT(refusal(PlaneGroupName::kP4, nearly_square), HasSubstr("it fits squares"));
    EXPECT_THAT(refusal(PlaneGroupName::kP3, Lattice::rectangle(1, 1)), HasSubstr("hexagonal"));
    EXPECT_EQ(refusal(PlaneGroupName::kP2, oblique), "");
    EXPECT_EQ(refusal(PlaneGroupName::kPmm, nearly_square), "");
}

TEST(PlaneGroup, ReadsTheSeventeenWords) {
    for (const PlaneGroupRow& row : kPlaneGroups) EXPECT_EQ(parse_plane_group(row.word), row.name);
    EXPECT_THROW(parse_plane_group("p5"), InvalidInput);
    EXPECT_THROW(parse_plane_group(""), InvalidInput);
}

OrbitPlan plan_of(PlaneGroupName name, int n) {
    const PlaneGroup group(name, example_lattice(name));
    const SpecialPositions special = special_positions(group);
    const OrbitPlan plan = distribute(group, special, n);
    EXPECT_EQ(n_sites(group, special, plan), n);
    return plan;
}

TEST(OrbitPlan, OccupiesCentresOfTheHighestOrderFirst) {
    EXPECT_EQ(plan_of(PlaneGroupName::kP4m, 240).n_general, 30);
    EXPECT_EQ(plan_of(PlaneGroupName::kP4m, 241).at_centres, std::vector({true, false, false}));
    EXPECT_EQ(plan_of(PlaneGroupName::kP4m, 242).at_centres, std::vector({true, true, false}));
    EXPECT_EQ(plan_of(PlaneGroupName::kP4m, 243).at_centres, std::vector({true, false, true}));
    EXPECT_EQ(plan_of(PlaneGroupName::kP6m, 49).at_centres, std::vector({true, false, false}));
    EXPECT_EQ(plan_of(PlaneGroupName::kPm, 7).on_mirrors, std::vector({1, 0}));
    EXPECT_EQ(plan_of(PlaneGroupName::kP4m, 5).on_mirrors, std::vector({1, 0, 0}));
}

TEST(OrbitPlan, NamesTheNearestNumbers) {
    const PlaneGroup group(PlaneGroupName::kPg, Lattice::rectangle(1, 2));
    const SpecialPositions special = special_positions(group);
    const auto message = [&](int n) {
        return testing::refusal_of([&] { distribute(group, special, n); });
    };
    EXPECT_THAT(message(7), HasSubstr("take 6 or 8"));
    EXPECT_THAT(message(1), HasSubstr("take 2"));
    EXPECT_EQ(message(2), "");
}

}  // namespace
}  // namespace pcvt::plane
