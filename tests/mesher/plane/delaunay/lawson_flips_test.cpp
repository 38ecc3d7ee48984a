#include "mesher/plane/delaunay/lawson_flips.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "mesher/plane/delaunay/periodic_delaunay.hpp"
#include "tests/support/lattices.hpp"
#include "tests/support/special_sites.hpp"

namespace pcvt::plane {
namespace {

using testing::lattices;

/// A Delaunay triangulation with Lawson's algorithm on it.
struct Fixture {
    explicit Fixture(const Sites& given)
        : sites(given),
          triangulation(PeriodicDelaunay(given).triangulation()),
          flips(triangulation, sites.coordinates(), gram_of(sites.reduction().reduced)) {}

    /// Flips h if both triangles stay counter-clockwise; returns whether it did.
    bool flip_if_convex(int h) {
        const int o = triangulation.opposite(h);
        triangulation.flip(h);
        if (flips.is_counter_clockwise(h / 3) && flips.is_counter_clockwise(o / 3)) return true;
        triangulation.flip(h);
        return false;
    }

    Sites sites;
    TorusTriangulation triangulation;
    LawsonFlips flips;
};

using Edges = std::vector<std::tuple<SiteId, SiteId, Offset>>;

Edges edges(const TorusTriangulation& t) {
    Edges edges;
    for (int h = 0; h < t.n_halfedges(); ++h) {
        edges.emplace_back(t.corner(h).site, t.corner(TorusTriangulation::next(h)).site,
                           t.edge_offset(h));
    }
    std::sort(edges.begin(), edges.end());
    return edges;
}

/// Flips random edges whose flips keep triangles counter-clockwise.
void shuffle(Fixture& fixture, std::mt19937_64& random) {
    const int n_halfedges = fixture.triangulation.n_halfedges();
    for (int k = 0; k < n_halfedges; ++k) {
        fixture.flip_if_convex(static_cast<int>(random() % n_halfedges));
    }
}

TEST(LawsonFlips, RestoreDelaunayFromAnyTriangulation) {
    std::mt19937_64 random(1);
    for (const auto& [name, lattice] : lattices()) {
        for (const int n : {2, 3, 4, 7, 50}) {
            SCOPED_TRACE(name + " n = " + std::to_string(n));
            Fixture fixture(Sites(lattice, uniform_points(lattice, n, random())));
            const Edges delaunay = edges(fixture.triangulation);
            shuffle(fixture, random);
            const bool away = edges(fixture.triangulation) != delaunay;
            EXPECT_TRUE(away || n < 5);
            EXPECT_EQ(fixture.flips.flip_all() > 0, away);
            EXPECT_EQ(edges(fixture.triangulation), delaunay);
            EXPECT_EQ(fixture.flips.flip_all(), 0);
        }
    }
}

TEST(LawsonFlips, ContinueFromTheSuspects) {
    const Lattice lattice({1, 0}, {0.37, 0.81});
    Fixture fixture(Sites(lattice, uniform_points(lattice, 200, 2)));
    const Edges delaunay = edges(fixture.triangulation);
    std::vector<int> suspects;
    EXPECT_EQ(fixture.flips.flip(suspects), 0);
    for (int h = 0; h < fixture.triangulation.n_halfedges(); h += 50) {
        if (fixture.flip_if_convex(h)) suspects.push_back(h);
    }
    EXPECT_GE(fixture.flips.flip(suspects), 1);
    EXPECT_TRUE(suspects.empty());
    EXPECT_EQ(edges(fixture.triangulation), delaunay);
}

/// Repeats each flip on a copy and compares.
class Witness final : public FlipObserver {
   public:
    explicit Witness(const Fixture& fixture) : fixture_(fixture), copy_(fixture.triangulation) {}

    void before_flip(int h) override {
        expect_equal();
        EXPECT_FALSE(fixture_.flips.is_locally_delaunay(h));
        copy_.flip(h);
        flipped_ = h;
    }
    void after_flip(int h) override {
        ++n_flips;
        EXPECT_EQ(h, flipped_);
        expect_equal();
        for (const int side : {h, copy_.opposite(h)}) {
            EXPECT_TRUE(fixture_.flips.is_counter_clockwise(side / 3));
        }
    }

    int n_flips = 0;

   private:
    void expect_equal() const { EXPECT_EQ(edges(copy_), edges(fixture_.triangulation)); }

    const Fixture& fixture_;
    TorusTriangulation copy_;
    int flipped_ = -1;
};

TEST(LawsonFlips, NotifyBeforeAndAfterEachFlip) {
    std::mt19937_64 random(3);
    Fixture fixture(Sites(Lattice({1, 0}, {7, 1}), uniform_points(Lattice({1, 0}, {7, 1}), 40, 3)));
    shuffle(fixture, random);
    std::vector<int> suspects(static_cast<std::size_t>(fixture.triangulation.n_halfedges()));
    for (int h = 0; h < fixture.triangulation.n_halfedges(); ++h) suspects[h] = h;
    Witness witness(fixture);
    EXPECT_EQ(fixture.flips.flip(suspects, &witness), witness.n_flips);
    EXPECT_GT(witness.n_flips, 10);
}

/// Expects that both tests agree with the predicates.
void expect_exact_answers(const Fixture& fixture) {
    const TorusTriangulation& t = fixture.triangulation;
    const Gram gram = gram_of(fixture.sites.reduction().reduced);
    const auto at = [&](Corner c) { return image(fixture.sites, c.site, c.offset); };
    for (int h = 0; h < t.n_halfedges(); ++h) {
        const Image p = at(t.corner(h));
        const Image q = at(t.corner(TorusTriangulation::next(h)));
        const Image r = at(t.corner(TorusTriangulation::previous(h)));
        const bool turns = orientation(p, q, r) > 0;
        ASSERT_EQ(fixture.flips.is_counter_clockwise(h / 3), turns);
        if (!turns) continue;
        const bool outside = in_circle(gram, p, q, r, at(t.apex_across(h))) <= 0;
        ASSERT_EQ(fixture.flips.is_locally_delaunay(h), outside);
    }
}

TEST(LawsonFlips, TestExactly) {
    std::mt19937_64 random(4);
    for (const auto& [name, lattice] : lattices()) {
        SCOPED_TRACE(name);
        Fixture fixture(Sites(lattice, uniform_points(lattice, 30, 4)));
        for (int k = 0; k < 60; ++k) {
            fixture.triangulation.flip(static_cast<int>(random() % 180));
            expect_exact_answers(fixture);
        }
    }
}

// For either diagonal of each square: flips of ties would never end.
TEST(LawsonFlips, LeaveTiesAlone) {
    Fixture fixture(testing::grid_sites(Lattice::rectangle(1, 1), 4, 4, 0, 0));
    const Edges first = edges(fixture.triangulation);
    int n_ties = 0;
    for (int h = 0; h < fixture.triangulation.n_halfedges(); ++h) {
        if (!fixture.flip_if_convex(h)) continue;
        if (fixture.flips.is_locally_delaunay(h)) ++n_ties;
        std::vector<int> suspects{h};
        fixture.flips.flip(suspects);
        EXPECT_EQ(fixture.flips.flip_all(), 0);
    }
    EXPECT_GE(n_ties, 16);
    EXPECT_NE(edges(fixture.triangulation), first);
}

}  // namespace
}  // namespace pcvt::plane
