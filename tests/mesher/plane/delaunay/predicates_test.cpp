#include "mesher/plane/delaunay/predicates.hpp"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_int.hpp>

#include "tests/support/lattices.hpp"

namespace pcvt::plane {
namespace {

using Rational = boost::multiprecision::cpp_rational;
using testing::lattices;

/// The reference for the predicates: plain determinants in rational numbers.
struct RationalPoint {
    Rational u;
    Rational v;
};

RationalPoint exact(const Image& p) {
    return {Rational(p.u) + p.offset.i, Rational(p.v) + p.offset.j};
}

int exact_orientation(const Image& p, const Image& q, const Image& r) {
    const auto [pu, pv] = exact(p);
    const auto [qu, qv] = exact(q);
    const auto [ru, rv] = exact(r);
    const Rational det = (qu - pu) * (rv - pv) - (qv - pv) * (ru - pu);
    return det.sign();
}

int exact_in_circle(const Gram& g, const Image& p, const Image& q, const Image& r, const Image& s) {
    std::array<std::array<Rational, 3>, 3> row;
    const std::array<const Image*, 3> corner{&p, &q, &r};
    const auto [su, sv] = exact(s);
    for (int k = 0; k < 3; ++k) {
        const auto [u, v] = exact(*corner[k]);
        const Rational du = u - su;
        const Rational dv = v - sv;
        row[k] = {du, dv, g.aa * du * du + 2 * Rational(g.ab) * du * dv + g.bb * dv * dv};
    }
    Rational det = 0;
    for (int k = 0; k < 3; ++k) {
        const auto& a = row[(k + 1) % 3];
        const auto& b = row[(k + 2) % 3];
        det += row[k][2] * (a[0] * b[1] - a[1] * b[0]);
    }
    return det.sign();
}

/// Images on a coarse grid in [-2, 3)^2, with one coordinate in three moved by one unit in the last
/// place: many ties and near ties.
Image random_image(std::mt19937_64& random) {
    const auto pick = [&](int n) { return static_cast<int>(random() % n); };
    const auto whole = [&] { return pick(3) == 0 ? pick(5) - 2 : 0; };
    const auto coordinate = [&] {
        return whole() + pick(8) / 8.0 + (pick(3) == 0 ? pick(3) * 0x1p-51 : 0);
    };
    return {coordinate(), coordinate(), 0, {pick(3) - 1, pick(3) - 1}};
}

TEST(Predicates, OrientationEqualsItsRationalReference) {
    std::mt19937_64 random(1);
    for (int k = 0; k < 20000; ++k) {
        const Image p = random_image(random);
        const Image q = random_image(random);
        const Image r = random_image(random);
        ASSERT_EQ(orientation(p, q, r), exact_orientation(p, q, r));
    }
}

TEST(Predicates, InCircleEqualsItsRationalReference) {
    std::mt19937_64 random(2);
    for (const auto& [name, lattice] : lattices()) {
        const Gram gram = gram_of(reduce(lattice).reduced);
        for (int k = 0; k < 1200; ++k) {
            const Image p = random_image(random);
            const Image q = random_image(random);
            const Image r = random_image(random);
            const Image s = random_image(random);
            ASSERT_EQ(in_circle(gram, p, q, r, s), exact_in_circle(gram, p, q, r, s)) << name;
        }
    }
}

TEST(Predicates, FarImagesAreDecidedExactly) {
    const Gram gram = gram_of(Lattice::rectangle(1, 1));
    const Image p{0, 0, 0, {0, 0}};
    const Image q{0, 0, 0, {1000000, 0}};
    const Image r{0x1p-51, 0, 0, {0, 1000000}};
    const Image s{0, 0, 0, {1000000, 1000000}};
    EXPECT_EQ(in_circle(gram, p, q, r, s), exact_in_circle(gram, p, q, r, s));
    EXPECT_EQ(orientation(p, q, {0, 0x1p-51, 0, {500000, 0}}), 1);
}

TEST(Predicates, ACommonTranslationChangesNothing) {
    std::mt19937_64 random(3);
    const Gram gram = gram_of(reduce(Lattice({1, 0}, {0.37, 0.81})).reduced);
    const auto moved = [](Image p) { return Image{p.u, p.v, p.site, p.offset + Offset{1, -1}}; };
    for (int k = 0; k < 5000; ++k) {
        const Image p = random_image(random);
        const Image q = random_image(random);
        const Image r = random_image(random);
        const Image s = random_image(random);
        ASSERT_EQ(orientation(p, q, r), orientation(moved(p), moved(q), moved(r)));
        ASSERT_EQ(in_circle(gram, p, q, r, s),
                  in_circle(gram, moved(p), moved(q), moved(r), moved(s)));
    }
}

TEST(Predicates, ExactlyOneImageOfATriangleHasItsCircumcentreInTheDomain) {
    std::mt19937_64 random(4);
    for (const auto& [name, lattice] : lattices()) {
        const Gram gram = gram_of(reduce(lattice).reduced);
        for (int k = 0; k < 200; ++k) {
            // Right angles: the circumcentre is the midpoint of the hypotenuse, often on the seam.
            const double u = static_cast<int>(random() % 8) / 8.0;
            const double v = static_cast<int>(random() % 8) / 8.0;
            const Image p{u, v, 0, {}};
            const Image q{u, v, 0, {1, 0}};
            const Image r{u, v, 0, {0, 1}};
            int count = 0;
            for (int i = -3; i <= 3; ++i) {
                for (int j = -3; j <= 3; ++j) {
                    const auto at = [&](Image x) {
                        x.offset = x.offset + Offset{i, j};
                        return x;
                    };
                    count += circumcentre_in_domain(gram, at(p), at(q), at(r));
                }
            }
            ASSERT_EQ(count, 1) << name << " " << u << " " << v;
        }
    }
}

/// Solves 2 G(d, c) = G(d, d) for both edges d in rational numbers.
Vec2 exact_circumcentre(const Gram& g, const Image& p, const Image& q, const Image& r) {
    const auto [pu, pv] = exact(p);
    const auto [qu, qv] = exact(q);
    const auto [ru, rv] = exact(r);
    const auto row = [&](const Rational& du, const Rational& dv) {
        const Rational a = g.aa * du + Rational(g.ab) * dv;
        const Rational b = Rational(g.ab) * du + g.bb * dv;
        return std::array<Rational, 3>{a, b, (a * du + b * dv) / 2};
    };
    const auto d = row(qu - pu, qv - pv);
    const auto e = row(ru - pu, rv - pv);
    const Rational det = d[0] * e[1] - d[1] * e[0];
    return {static_cast<double>(Rational((d[2] * e[1] - e[2] * d[1]) / det)),
            static_cast<double>(Rational((d[0] * e[2] - e[0] * d[2]) / det))};
}

TEST(Predicates, CircumcentresOfThinTrianglesKeepTwelveDigits) {
    std::mt19937_64 random(5);
    for (const auto& [name, lattice] : lattices()) {
        const Gram gram = gram_of(reduce(lattice).reduced);
        for (int k = 0; k < 300; ++k) {
            const Image p = random_image(random);
            const Image q = random_image(random);
            Image r{(p.u + q.u) / 2, (p.v + q.v) / 2, 0, p.offset};
            r.v = wrap(r.v + std::ldexp(1.0, -static_cast<int>(random() % 50))).fraction;
            if (orientation(p, q, r) <= 0) continue;
            const Vec2 expected = exact_circumcentre(gram, p, q, r);
            const Vec2 actual = circumcentre(gram, p, q, r);
            ASSERT_LT((actual - expected).norm(), 1e-11 * expected.norm()) << name;
        }
    }
}

TEST(Predicates, TheFilterFailsOnGridsAndRarelyOnRandomSites) {
    const Gram gram = gram_of(Lattice::rectangle(1, 1));
    const auto grid = [](int i, int j) { return Image{i / 8.0, j / 8.0, 0, {}}; };
    auto before = predicate_counts();
    for (int i = 0; i < 7; ++i)
        in_circle(gram, grid(i, 0), grid(i + 1, 0), grid(i + 1, 1), grid(i, 1));
    EXPECT_EQ(predicate_counts().exact - before.exact, 7);

    before = predicate_counts();
    const Points p = uniform_points(Lattice::rectangle(1, 1), 4000, 1);
    for (Eigen::Index k = 0; k + 3 < p.cols(); k += 4) {
        const auto at = [&](Eigen::Index c) { return Image{p(0, c), p(1, c), 0, {}}; };
        in_circle(gram, at(k), at(k + 1), at(k + 2), at(k + 3));
    }
    EXPECT_EQ(predicate_counts().calls - before.calls, 1000);
    EXPECT_LE(predicate_counts().exact - before.exact, 1);
}

}  // namespace
}  // namespace pcvt::plane
