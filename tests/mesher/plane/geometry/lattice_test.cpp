#include "mesher/plane/geometry/lattice.hpp"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <limits>

#include "mesher/base/error.hpp"
#include "tests/support/lattices.hpp"

namespace pcvt::plane {
namespace {

using testing::lattices;
using testing::random_lattice;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Law 1 of Lattice.
TEST(Lattice, CoordinatesRoundTrip) {
    for (const auto& [name, lattice] : lattices()) {
        const Vec2 p = 0.3 * lattice.a() - 1.7 * lattice.b();
        const double size = lattice.a().norm() + lattice.b().norm();
        EXPECT_LT((lattice.to_position(lattice.to_lattice(p)) - p).norm(), 1e-14 * size) << name;
    }
}

// Law 2 of Lattice: plain products would lose ten digits here.
TEST(Lattice, TranslationIsAccurateWhereTermsCancel) {
    const Lattice lattice({1, 1.0 / 3}, {1e6 + 0.125, 1e6 / 3});
    const Offset offset{-1000000, 1};
    using Rational = boost::multiprecision::cpp_rational;
    const auto y = static_cast<double>(Rational(offset.i) * Rational(lattice.a().y()) +
                                       Rational(lattice.b().y()));
    const Vec2 translation = lattice.translation(offset);
    EXPECT_EQ(translation.x(), 0.125);
    EXPECT_NEAR(translation.y(), y, 0x1.8p-52 * std::abs(y));
}

// In rectangles the products with zeros drop out: every position is a rounded product, no zero is
// negative, and what is not finite stays so.
TEST(Lattice, PositionsInRectanglesAreRoundedProducts) {
    const double width = 1.0 / 3;
    const double height = 7e-30;
    const Lattice lattice = Lattice::rectangle(width, height);
    for (const double u : {0.0, -0.0, 0.1, -0.3, 1e-300, 5e-324, 1e300}) {
        for (const double v : {0.0, -0.0, 0.7, -1e-310, 3e10}) {
            const Vec2 p = lattice.to_position({u, v});
            EXPECT_EQ(p, Vec2(u * width, v * height));
            EXPECT_FALSE(p.x() == 0 && std::signbit(p.x()) && u == 0) << u << ' ' << v;
            EXPECT_FALSE(p.y() == 0 && std::signbit(p.y()) && v == 0) << u << ' ' << v;
        }
        EXPECT_TRUE(std::isnan(lattice.to_position({u, kInfinity}).x()));
    }
}

// Laws 1 to 3 of Reduction.
void expect_reduced(const Lattice& lattice, const std::string& name) {
    const Reduction reduction = reduce(lattice);
    const Vec2 a = reduction.reduced.a();
    const Vec2 b = reduction.reduced.b();
    const auto& m = reduction.m;
    EXPECT_EQ(std::abs(m[0] * m[3] - m[1] * m[2]), 1) << name;
    EXPECT_EQ(a, lattice.translation({m[0], m[1]})) << name;
    EXPECT_EQ(b, lattice.translation({m[2], m[3]})) << name;
    EXPECT_LE(a.norm(), b.norm() * (1 + 1e-11)) << name;
    EXPECT_LE(std::abs(a.dot(b)), a.squaredNorm() * (0.5 + 1e-11)) << name;
    EXPECT_TRUE(reduction.reduced.right_handed()) << name;
    const Offset offset{3, -2};
    const Vec2 difference =
        lattice.translation(reduction.to_original(offset)) - reduction.reduced.translation(offset);
    EXPECT_LT(difference.norm(), 1e-14 * (3 * a.norm() + 2 * b.norm())) << name;
}

TEST(Reduction, LawsHoldOnEveryTestLattice) {
    for (const auto& [name, lattice] : lattices()) expect_reduced(lattice, name);
}

TEST(Reduction, LawsHoldOnRandomLattices) {
    std::mt19937_64 random(1);
    for (int k = 0; k < 2000; ++k) expect_reduced(random_lattice(random), std::to_string(k));
}

TEST(Reduction, TiesTerminate) {
    for (const double half : {0.5, -0.5, 1.5, 0.5 + 1e-16, 0.5 - 1e-16}) {
        for (const double height : {0.9, 2.0, std::sqrt(0.75), 1 / 3.0}) {
            expect_reduced(Lattice({1, 0}, {half, height}), std::to_string(half));
            expect_reduced(Lattice({half, height}, {1, 0}), "exchanged");
            expect_reduced(Lattice({0.1, 0.3}, {half * 0.1 - 0.3, half * 0.3 + 0.1}), "rotated");
        }
    }
}

TEST(Reduction, KeepsAReducedBasis) {
    const std::array<int, 4> identity{1, 0, 0, 1};
    EXPECT_EQ(reduce(Lattice::rectangle(1, 1)).m, identity);
    EXPECT_EQ(reduce(Lattice({1, 0}, {0.37, 0.95})).m, identity);
}

TEST(Lattice, RejectsVectorsThatSpanNoLattice) {
    EXPECT_THROW(Lattice({1, 0}, {2, 0}), InvalidInput);
    EXPECT_THROW(Lattice({0.1, 0.3}, {0.2, 0.6}), InvalidInput);
    EXPECT_THROW(Lattice({0, 0}, {0, 1}), InvalidInput);
    EXPECT_THROW(Lattice({kInfinity, 0}, {0, 1}), InvalidInput);
    EXPECT_THROW(Lattice({1, 0}, {0, std::nan("")}), InvalidInput);
    EXPECT_THROW(Lattice::rectangle(1e-61, 1e-61), InvalidInput);
    EXPECT_THROW(Lattice::rectangle(1e61, 1), InvalidInput);
}

TEST(Reduction, RejectsExtremeLattices) {
    EXPECT_THROW(reduce(Lattice({1, 0}, {1e9, 1})), InvalidInput);
    EXPECT_THROW(reduce(Lattice::rectangle(1, 1e7)), InvalidInput);
}

TEST(Wrap, FractionIsInTheHalfOpenInterval) {
    std::mt19937_64 random(2);
    std::uniform_real_distribution<double> uniform(-3, 3);
    for (int k = 0; k < 10000; ++k) {
        const double u = uniform(random);
        const Wrapped wrapped = wrap(u);
        EXPECT_GE(wrapped.fraction, 0);
        EXPECT_LT(wrapped.fraction, 1);
        EXPECT_EQ(std::fmod(wrapped.fraction, 0x1p-51), 0);
        EXPECT_NEAR(wrapped.whole + wrapped.fraction, u, 0x1p-52);
    }
}

TEST(Wrap, NeverReturnsOne) {
    for (const double u : {-1e-17, -0x1p-54, -0x1p-53, 1 - 0x1p-53, 3 - 0x1p-51, -0.0, 7.0}) {
        const Wrapped wrapped = wrap(u);
        EXPECT_GE(wrapped.fraction, 0) << u;
        EXPECT_LT(wrapped.fraction, 1) << u;
        EXPECT_NEAR(wrapped.whole + wrapped.fraction, u, 0x1p-51) << u;
    }
    EXPECT_EQ(wrap(-1e-17).whole, 0);
    EXPECT_EQ(wrap(-1e-17).fraction, 0);
}

}  // namespace
}  // namespace pcvt::plane
