#include "mesher/plane/proof/vertex_orbits.hpp"

#include <gmock/gmock.h>

#include <random>

namespace pcvt::plane {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

constexpr double kTolerance = 1e-9;

std::vector<Lattice> orbit_lattices() {
    return {Lattice::rectangle(1, 1), Lattice({1, 0}, {7, 1}), Lattice({0.2, 1}, {1, 0.1}),
            Lattice::rectangle(50, 1), Lattice({1, 0}, {-0.5, 0.86})};
}

/// Images of a few points, each displaced by up to 0.4 tolerances. Points may lie on the seam.
struct Cloud {
    std::vector<Vec2> points;
    std::vector<int> orbit;
    std::vector<Offset> offset;
};

Cloud random_cloud(const Lattice& lattice, std::mt19937& random) {
    Cloud cloud;
    std::uniform_real_distribution<double> noise(-0.4 * kTolerance, 0.4 * kTolerance);
    for (int k = 0; k < 60; ++k) {
        const int orbit = static_cast<int>(random() % 20);
        const Offset offset{static_cast<int>(random() % 9) - 4, static_cast<int>(random() % 9) - 4};
        // The coordinates are multiples of 1/5 and 1/4, so all 20 points differ and some lie on the
        // border of the domain.
        const Vec2 u(orbit % 5 / 5.0 + offset.i, orbit / 5 / 4.0 + offset.j);
        cloud.points.push_back(lattice.to_position(u) + Vec2(noise(random), noise(random)));
        cloud.orbit.push_back(orbit);
        cloud.offset.push_back(offset);
    }
    return cloud;
}

TEST(VertexOrbits, AreTheOrbitsOfTheGeneratingPoints) {
    std::mt19937 random(1);
    for (int round = 0; round < 200; ++round) {
        for (const Lattice& lattice : orbit_lattices()) {
            const Cloud cloud = random_cloud(lattice, random);
            const VertexOrbits found = find_vertex_orbits(lattice, cloud.points, kTolerance);
            for (int v = 0; v < 60; ++v) {
                int first = 0;
                while (cloud.orbit[first] != cloud.orbit[v]) ++first;
                ASSERT_EQ(found.representative[v], first);
                ASSERT_EQ(found.offset[v], cloud.offset[v] - cloud.offset[first]);
                int copy = 0;
                while (cloud.orbit[copy] != cloud.orbit[v] || cloud.offset[copy] != cloud.offset[v])
                    ++copy;
                ASSERT_EQ(found.first_copy[v], copy);
            }
        }
    }
}

TEST(VertexOrbits, PairsAreFoundWhereverTheyLie) {
    // With this many pairs, some lie across every kind of border between bins.
    std::mt19937 random(2);
    std::uniform_real_distribution<double> uniform(0, 1);
    for (const Lattice& lattice : orbit_lattices()) {
        std::vector<Vec2> points;
        for (int v = 0; v < 40000; v += 2) {
            points.push_back(lattice.to_position({uniform(random), uniform(random)}));
            const Vec2 apart(uniform(random) - 0.5, uniform(random) - 0.5);
            points.push_back(points.back() + lattice.translation({-1, 2}) + kTolerance * apart);
        }
        const VertexOrbits found = find_vertex_orbits(lattice, points, kTolerance);
        for (int v = 0; v < 40000; v += 2) {
            ASSERT_EQ(found.representative[v + 1], v);
            ASSERT_EQ(found.offset[v + 1], (Offset{-1, 2}));
        }
    }
}

TEST(VertexOrbits, EndAtTheToleranceInEachCoordinate) {
    const Lattice lattice = Lattice::rectangle(1, 1);
    const auto orbits = [&](const Vec2& apart) {
        const Vec2 p(0.25, 0.5);
        return find_vertex_orbits(lattice,
                                  std::vector<Vec2>{p, p + lattice.translation({2, -1}) + apart},
                                  kTolerance)
            .representative;
    };
    EXPECT_THAT(orbits({0.99 * kTolerance, -0.99 * kTolerance}), ElementsAre(0, 0));
    EXPECT_THAT(orbits({1.01 * kTolerance, 0}), ElementsAre(0, 1));
    EXPECT_THAT(orbits({0, -1.01 * kTolerance}), ElementsAre(0, 1));
}

TEST(VertexOrbits, ChainsJoinButMustNotGrowLong) {
    const Lattice lattice = Lattice::rectangle(1, 1);
    std::vector<Vec2> chain;
    for (int k = 0; k < 5; ++k) chain.emplace_back(0.9 * k * kTolerance, 0.25);
    EXPECT_THAT(find_vertex_orbits(lattice, chain, kTolerance).representative,
                ElementsAre(0, 0, 0, 0, 0));
    chain.emplace_back(0.9 * 5 * kTolerance, 1.25);
    EXPECT_THAT([&] { find_vertex_orbits(lattice, chain, kTolerance); },
                ThrowsMessage<NotATile>(HasSubstr("vertices 0 and 5 are joined by a chain")));
}

// The search compares each two vertices of a bin, which would take hours for a million of them.
TEST(VertexOrbits, ACrowdOfCoincidentVerticesIsRefusedSoon) {
    const Lattice lattice = Lattice::rectangle(1, 1);
    EXPECT_THAT(
        [&] {
            find_vertex_orbits(lattice, std::vector<Vec2>(3000, Vec2(0.3, 0.4)), kTolerance, {});
        },
        ThrowsMessage<NotATile>(HasSubstr("thousands of vertices lie as near to vertex ")));
    const VertexOrbits few =
        find_vertex_orbits(lattice, std::vector<Vec2>(700, Vec2(0.3, 0.4)), kTolerance, {});
    EXPECT_EQ(few.representative.back(), 0);
}

TEST(VertexOrbits, OfNoVerticesAreEmpty) {
    EXPECT_TRUE(find_vertex_orbits(Lattice::rectangle(1, 1), std::span<const Vec2>(), kTolerance)
                    .offset.empty());
}

}  // namespace
}  // namespace pcvt::plane
