#include "mesher/space/delaunay/power_predicates.hpp"

#include <CGAL/MP_Float.h>
#include <gtest/gtest.h>

#include <array>
#include <random>

#include "tests/support/random_numbers.hpp"
#include "tests/support/space_lattices.hpp"

namespace pcvt::space {
namespace {

using Exact = CGAL::MP_Float;

/// A positive tetrahedron and a point, with weights.
using Five = std::array<WeightedImage, 5>;

Exact exact_height(const Gram& g, const WeightedImage& p) {
    const Exact x(p.at.at.x());
    const Exact y(p.at.at.y());
    const Exact z(p.at.at.z());
    return x * x * Exact(g.aa) + y * y * Exact(g.bb) + z * z * Exact(g.cc) +
           Exact(2) * (x * y * Exact(g.ab) + x * z * Exact(g.ac) + y * z * Exact(g.bc)) -
           Exact(p.weight);
}

/// The sign by the determinant of five lifted points, expanded along its last column.
int exact_side(const Gram& gram, const Five& five) {
    const auto row = [&](int k, int column) {
        if (column == 3) return exact_height(gram, five[k]);
        return Exact(five[k].at.at[column]);
    };
    Exact sum(0);
    std::array<int, 4> kept{};
    for (int omitted = 0; omitted < 5; ++omitted) {
        for (int k = 0, m = 0; k < 5; ++k) {
            if (k != omitted) kept[m++] = k;
        }
        Exact minor(0);
        std::array<int, 4> order{0, 1, 2, 3};
        do {
            int sign = 1;
            for (int a = 0; a < 4; ++a) {
                for (int b = a + 1; b < 4; ++b) sign = order[a] > order[b] ? -sign : sign;
            }
            Exact product(sign);
            for (int a = 0; a < 4; ++a) product = product * row(kept[a], order[a]);
            minor = minor + product;
        } while (std::next_permutation(order.begin(), order.end()));
        sum = omitted % 2 == 0 ? sum + minor : sum - minor;
    }
    return -CGAL::sign(sum);
}

Five random_five(std::mt19937_64& random, bool near_a_tie) {
    for (;;) {
        Five five;
        for (int k = 0; k < 5; ++k) {
            Vec3 at;
            for (double& x : at) {
                x = near_a_tie ? testing::random_integer(random, 0, 3) / 4.0
                               : std::nearbyint(testing::random_number(random) * kGrid) / kGrid;
            }
            const double weight = near_a_tie ? testing::random_integer(random, 0, 2) * 0.125
                                             : testing::random_number(random);
            five[k] = {{at, {k, {}}}, rounded_weight(weight)};
        }
        if (near_a_tie) {
            const int k = testing::random_integer(random, 0, 4);
            five[k].weight += testing::random_integer(random, -1, 1) * 0x1p-52;
        }
        if (orientation(five[0].at, five[1].at, five[2].at, five[3].at) > 0) return five;
    }
}

int side_of(const Gram& gram, const Five& f) {
    return in_power_sphere(gram, f[0], f[1], f[2], f[3], f[4]);
}

TEST(PowerPredicates, HaveTheSignsOfExactNumbers) {
    std::mt19937_64 random(1);
    int n_ties = 0;
    for (const auto& [name, lattice] : testing::space_lattices()) {
        SCOPED_TRACE(name);
        const Gram gram = gram_of(reduce(lattice).reduced);
        for (int k = 0; k < 200; ++k) {
            const Five five = random_five(random, k % 2 == 0);
            const int side = side_of(gram, five);
            ASSERT_EQ(side, exact_side(gram, five)) << k;
            n_ties += side == 0 ? 1 : 0;
        }
    }
    EXPECT_GT(n_ties, 20);
}

TEST(PowerPredicates, WithoutWeightsAreThoseOfTheSphere) {
    std::mt19937_64 random(2);
    const Gram gram = gram_of(testing::kCube);
    for (int k = 0; k < 400; ++k) {
        Five five = random_five(random, k % 2 == 0);
        for (WeightedImage& p : five) p.weight = 0.375;
        const auto& [p, q, r, s, t] = five;
        ASSERT_EQ(side_of(gram, five), in_sphere(gram, p.at, q.at, r.at, s.at, t.at));
        ASSERT_EQ(violates_regularity(gram, p, q, r, s, t),
                  violates_delaunay(gram, p.at, q.at, r.at, s.at, t.at));
    }
}

// A weight that grows lowers its lifted point, so that it comes below the hyperplane of the others.
TEST(PowerPredicates, SeeTheSmallestDifferenceOfWeights) {
    const auto at = [](double x, double y, double z, SiteId s, double w) {
        return WeightedImage{{Vec3(x, y, z), {s, {}}}, w};
    };
    const Gram gram = gram_of(testing::kCube);
    const Five tie{at(0, 0, 0, 0, 0.5), at(0.5, 0, 0, 1, 0.5), at(0, 0.5, 0, 2, 0.5),
                   at(0, 0, 0.5, 3, 0.5), at(0.5, 0.5, 0.5, 4, 0.5)};
    EXPECT_EQ(side_of(gram, tie), 0);
    for (const double least : {0x1p-100, 0x1p-53}) {
        Five other = tie;
        for (WeightedImage& p : other) p.weight = 0;
        other[4].weight = least;
        EXPECT_EQ(side_of(gram, other), 1) << least;
        other[4].weight = -least;
        EXPECT_EQ(side_of(gram, other), -1) << least;
    }
}

TEST(PowerPredicates, RoundWeightsToTheirGrid) {
    EXPECT_EQ(rounded_weight(0.1), 0.1);
    EXPECT_EQ(rounded_weight(-0x1p42), -0x1p42);
    EXPECT_EQ(rounded_weight(0x1.8p-101), 0x1p-100);
    EXPECT_EQ(rounded_weight(0x1p-102), 0.0);
}

// The orthocentre has equal power distances, also for a flat tetrahedron.
TEST(PowerPredicates, OrthocentreHasEqualPowerDistances) {
    std::mt19937_64 random(3);
    for (int k = 0; k < 100; ++k) {
        const Five five = random_five(random, false);
        const Gram gram = gram_of(testing::kCube);
        std::array<Vec3, 3> d;
        std::array<double, 4> weight;
        for (int c = 0; c < 4; ++c) {
            weight[c] = five[c].weight;
            if (c > 0) d[c - 1] = five[c].at.at - five[0].at.at;
        }
        const Vec3 o = exact_orthocentre(gram, d, weight);
        const auto power = [&](const Vec3& from, double w) {
            const Vec3 e = o - from;
            return gram.squared_length(e.x(), e.y(), e.z()) - w;
        };
        const double first = power(Vec3::Zero(), weight[0]);
        for (int c = 1; c < 4; ++c) {
            ASSERT_NEAR(power(d[c - 1], weight[c]), first, 1e-13 * (1 + o.squaredNorm()));
        }
    }
}

}  // namespace
}  // namespace pcvt::space
