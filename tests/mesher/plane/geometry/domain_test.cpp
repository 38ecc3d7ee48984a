#include "mesher/plane/geometry/domain.hpp"

#include <gtest/gtest.h>

#include <random>

#include "mesher/plane/geometry/sites.hpp"

namespace pcvt::plane {
namespace {

/// Rectangles of either order and sign, reduced and unreduced oblique bases.
const Lattice kLattices[] = {
    Lattice::rectangle(1, 1),      Lattice::rectangle(2, 1),  Lattice::rectangle(1, 20),
    Lattice({0, 1}, {3, 0}),       Lattice({-1, 0}, {0, -2}), Lattice({1, 0}, {0.3, 0.9}),
    Lattice({1, 0}, {0.37, 0.81}), Lattice({1, 0}, {7, 1}),   Lattice({5, 2}, {-3, -1}),
};

Vec2 placed(const Domain& domain, const Lattice& lattice, const Vec2& p) {
    return p + lattice.translation(domain.offset_into(p));
}

TEST(Domain, HoldsEveryPointOnceMovedLaw1) {
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> anywhere(-20, 20);
    for (const Lattice& lattice : kLattices) {
        const Vec2 origin(anywhere(random), anywhere(random));
        const Domain domain(lattice, origin);
        const Lattice basis = reduce(lattice).reduced;
        for (int k = 0; k < 200; ++k) {
            const Vec2 p(anywhere(random), anywhere(random));
            // The domain of a reduced basis is the parallelogram of that basis round the centre.
            const Vec2 u = basis.to_lattice(placed(domain, lattice, p) - domain.centre());
            EXPECT_LE(u.cwiseAbs().maxCoeff(), 0.5 + 1e-9);
        }
    }
}

TEST(Domain, HasTheCentreOfTheGivenParallelogramLaw2) {
    for (const Lattice& lattice : kLattices) {
        const Vec2 origin(0.25, -3);
        const Vec2 expected = origin + (lattice.a() + lattice.b()) / 2;
        EXPECT_LT((Domain(lattice, origin).centre() - expected).norm(), 1e-14);
    }
}

TEST(Domain, OfARectangleIsTheRectangleAtTheOriginWithItsLowerSides) {
    const Lattice lattice = Lattice::rectangle(2, 1);
    const Domain domain(lattice, {0, 0});
    EXPECT_EQ(domain.corner(), Vec2(0, 0));
    EXPECT_EQ(domain.opposite_corner(), Vec2(2, 1));
    EXPECT_EQ(placed(domain, lattice, {0, 0}), Vec2(0, 0));
    EXPECT_EQ(placed(domain, lattice, {2, 1}), Vec2(0, 0));
    EXPECT_EQ(placed(domain, lattice, {-0.5, 1.75}), Vec2(1.5, 0.75));
    const Points sites = uniform_points(lattice, 50, 1);
    for (int s = 0; s < sites.cols(); ++s) {
        const Vec2 p = placed(domain, lattice, sites.col(s));
        EXPECT_TRUE(p.x() >= 0 && p.x() < 2 && p.y() >= 0 && p.y() < 1);
    }
}

}  // namespace
}  // namespace pcvt::plane
