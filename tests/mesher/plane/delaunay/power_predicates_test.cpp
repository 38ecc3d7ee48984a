#include "mesher/plane/delaunay/power_predicates.hpp"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_int.hpp>

#include "mesher/plane/delaunay/power_distance.hpp"
#include "tests/support/lattices.hpp"

namespace pcvt::plane {
namespace {

using Rational = boost::multiprecision::cpp_rational;
using testing::lattices;

/// The reference: plain determinants in rational numbers.
struct LiftedPoint {
    Rational u;
    Rational v;
    Rational height;
};

LiftedPoint lifted(const Gram& g, const WeightedImage& p, const WeightedImage& origin) {
    const Rational u =
        Rational(p.at.u) + p.at.offset.i - Rational(origin.at.u) - origin.at.offset.i;
    const Rational v =
        Rational(p.at.v) + p.at.offset.j - Rational(origin.at.v) - origin.at.offset.j;
    return {u, v,
            g.aa * u * u + 2 * Rational(g.ab) * u * v + g.bb * v * v - Rational(p.weight) +
                Rational(origin.weight)};
}

int rational_in_power_circle(const Gram& g, const WeightedImage& p, const WeightedImage& q,
                             const WeightedImage& r, const WeightedImage& s) {
    const LiftedPoint a = lifted(g, p, s);
    const LiftedPoint b = lifted(g, q, s);
    const LiftedPoint c = lifted(g, r, s);
    const Rational det = a.height * (b.u * c.v - b.v * c.u) + b.height * (c.u * a.v - c.v * a.u) +
                         c.height * (a.u * b.v - a.v * b.u);
    return det.sign();
}

double pick(std::mt19937_64& random, int n) { return static_cast<int>(random() % n); }

/// Images on a coarse grid, some of them moved by one unit in the last place.
Image random_image_in_domain(std::mt19937_64& random) {
    const auto coordinate = [&] {
        return pick(random, 8) / 8 + (pick(random, 3) == 0 ? pick(random, 3) * 0x1p-51 : 0);
    };
    const double u = coordinate();
    const double v = coordinate();
    return {u, v, 0, {int(pick(random, 3)) - 1, int(pick(random, 3)) - 1}};
}

/// Weights that give many ties and near ties, and weights of very different sizes.
WeightedImage random_weighted(std::mt19937_64& random) {
    const double coarse = pick(random, 5) / 64;
    const double fine = pick(random, 3) == 0 ? pick(random, 3) * 0x1p-56 : 0;
    const double odd = pick(random, 6) == 0 ? std::ldexp(1.0, -int(pick(random, 1000))) : 0;
    return {random_image_in_domain(random), coarse + fine + odd};
}

TEST(PowerPredicates, InPowerCircleEqualsItsRationalReference) {
    std::mt19937_64 random(1);
    for (const auto& [name, lattice] : lattices()) {
        const Gram gram = gram_of(reduce(lattice).reduced);
        for (int k = 0; k < 2000; ++k) {
            const WeightedImage p = random_weighted(random);
            const WeightedImage q = random_weighted(random);
            const WeightedImage r = random_weighted(random);
            const WeightedImage s = random_weighted(random);
            ASSERT_EQ(in_power_circle(gram, p, q, r, s), rational_in_power_circle(gram, p, q, r, s))
                << name;
        }
    }
}

TEST(PowerPredicates, ComparedPowerDistancesEqualTheirRationalReference) {
    std::mt19937_64 random(4);
    int n_ties = 0;
    for (const auto& [name, lattice] : lattices()) {
        const Gram gram = gram_of(reduce(lattice).reduced);
        for (int k = 0; k < 2000; ++k) {
            const WeightedImage at{random_image_in_domain(random), 0};
            const WeightedImage p = random_weighted(random);
            // Often the mirror image of p, which is as far.
            WeightedImage q = random_weighted(random);
            if (k % 4 == 0)
                q = {{2 * at.at.u - p.at.u, 2 * at.at.v - p.at.v, 0,
                      at.at.offset + at.at.offset - p.at.offset},
                     p.weight};
            const Rational difference = lifted(gram, p, at).height - lifted(gram, q, at).height;
            ASSERT_EQ(compare_power_distances(gram, at.at, p, q), difference.sign()) << name;
            n_ties += difference.sign() == 0;
        }
    }
    EXPECT_GT(n_ties, 1000);
}

TEST(PowerPredicates, EqualWeightsGiveTheAnswersOfDelaunay) {
    std::mt19937_64 random(2);
    for (const auto& [name, lattice] : lattices()) {
        const Gram gram = gram_of(reduce(lattice).reduced);
        for (int k = 0; k < 2000; ++k) {
            std::array<Image, 4> at;
            for (Image& x : at) x = random_image_in_domain(random);
            const double w = k % 2 == 0 ? 0 : pick(random, 9) / 7;
            ASSERT_EQ(in_power_circle(gram, {at[0], w}, {at[1], w}, {at[2], w}, {at[3], w}),
                      in_circle(gram, at[0], at[1], at[2], at[3]));
            if (orientation(at[0], at[1], at[2]) <= 0) continue;
            ASSERT_EQ(orthocentre(gram, {at[0], w}, {at[1], w}, {at[2], w}),
                      circumcentre(gram, at[0], at[1], at[2]));
            ASSERT_EQ(orthocentre_in_domain(gram, {at[0], w}, {at[1], w}, {at[2], w}),
                      circumcentre_in_domain(gram, at[0], at[1], at[2]));
        }
    }
}

TEST(PowerPredicates, ALargerWeightLowersASite) {
    const Gram gram = gram_of(Lattice::rectangle(1, 1));
    const WeightedImage p{{0, 0, 0, {}}, 0};
    const WeightedImage q{{0.5, 0, 1, {}}, 0};
    const WeightedImage r{{0, 0.5, 2, {}}, 0};
    EXPECT_EQ(in_power_circle(gram, p, q, r, {{0.5, 0.5, 3, {}}, 0}), 0);
    EXPECT_EQ(in_power_circle(gram, p, q, r, {{0.5, 0.5, 3, {}}, 1e-300}), 1);
    EXPECT_EQ(in_power_circle(gram, p, q, r, {{0.5, 0.5, 3, {}}, -1e-300}), -1);
    EXPECT_EQ(in_power_segment(gram, p, {{1 / 8.0, 0, 1, {}}, 0}, {{1 / 16.0, 0, 3, {}}, 0}), 1);
    EXPECT_EQ(in_power_segment(gram, p, {{1 / 8.0, 0, 1, {}}, 0}, {{1 / 16.0, 0, 3, {}}, -1}), -1);
}

TEST(PowerPredicates, TheOrthocentreHasEqualPowerDistances) {
    std::mt19937_64 random(3);
    for (const auto& [name, lattice] : lattices()) {
        const Gram gram = gram_of(reduce(lattice).reduced);
        const auto power = [&](const WeightedImage& p, const Vec2& c, const WeightedImage& origin) {
            const Vec2 d = difference(p.at, origin.at) + c;
            return gram.aa * d.x() * d.x() + 2 * gram.ab * d.x() * d.y() + gram.bb * d.y() * d.y() -
                   p.weight;
        };
        for (int k = 0; k < 500; ++k) {
            const WeightedImage p = random_weighted(random);
            const WeightedImage q = random_weighted(random);
            const WeightedImage r = random_weighted(random);
            if (orientation(p.at, q.at, r.at) <= 0) continue;
            const Vec2 c = orthocentre(gram, p, q, r);
            const double size = 1 + std::abs(power(p, c, p));
            ASSERT_NEAR(power(q, c, p), power(p, c, p), 1e-9 * size) << name;
            ASSERT_NEAR(power(r, c, p), power(p, c, p), 1e-9 * size) << name;
        }
    }
}

}  // namespace
}  // namespace pcvt::plane
