#include "mesher/plane/interfaces/random_circles.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "mesher/base/error.hpp"
#include "mesher/plane/geometry/walled_domain.hpp"
#include "mesher/plane/interfaces/inclusion_set.hpp"
#include "tests/support/lattices.hpp"

namespace pcvt::plane {
namespace {

const Lattice kOblique({1, 0}, {0.4, 0.8});

/// The least distance between two circles, over all images.
double least_gap(const Lattice& lattice, const std::vector<Circle>& circles) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < circles.size(); ++i) {
        for (std::size_t j = 0; j < circles.size(); ++j) {
            for (int k = 0; k < 49; ++k) {
                const Vec2 t = lattice.translation({k % 7 - 3, k / 7 - 3});
                const double apart = (circles[j].centre + t - circles[i].centre).norm();
                if (i == j && apart == 0) continue;
                least = std::min(least, apart - circles[i].radius - circles[j].radius);
            }
        }
    }
    return least;
}

TEST(RandomCircles, KeepTheGapAndHaveTheArea) {
    for (const Lattice& lattice : {Lattice::rectangle(1, 1), kOblique, Lattice::rectangle(3, 2)}) {
        for (const double fraction : {0.05, 0.3, 0.5, 0.6}) {
            for (const int n : {4, 10, 30, 100}) {
                const double gap =
                    0.1 * std::sqrt(fraction * lattice.area() / n / std::numbers::pi);
                const auto circles =
                    random_circles(lattice, {.fraction = fraction, .n = n, .gap = gap}, 0);
                ASSERT_EQ(std::ssize(circles), n);
                EXPECT_GE(least_gap(lattice, circles), gap * (1 - 1e-9));
                double area = 0;
                for (const Circle& circle : circles) area += shape_area(circle);
                EXPECT_NEAR(area / lattice.area(), fraction, 1e-12);
            }
        }
    }
}

TEST(RandomCircles, KeepTheGapFromWalls) {
    const Lattice lattice = Lattice::rectangle(1.5, 1);
    for (const WallsRow& row : kWalls) {
        for (std::uint64_t seed = 0; seed < 20; ++seed) {
            const auto circles =
                random_circles(lattice, {.fraction = 0.35, .n = 15, .gap = 0.01}, seed, row.walls);
            ASSERT_EQ(circles.size(), 15u);
            for (int axis = 0; axis < 2; ++axis) {
                if (!row.across[axis]) continue;
                for (const Circle& circle : circles) {
                    const double at = circle.centre[axis];
                    const double least = circle.radius + 0.01 - 1e-12;
                    EXPECT_GE(std::min(at, side_length(lattice, axis) - at), least);
                }
            }
            // Circles on both sides of a wall are not neighbours.
            const Lattice apart({row.across[0] ? 9.0 : 1.5, 0}, {0, row.across[1] ? 9.0 : 1.0});
            EXPECT_GE(least_gap(apart, circles), 0.01 - 1e-12);
            EXPECT_EQ(InclusionSet(lattice, circular_inclusions(circles, 1), row.walls).n_given(),
                      15);
        }
    }
}

TEST(RandomCircles, AreInclusions) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        const auto circles = random_circles(kOblique, {.fraction = 0.6, .n = 30}, seed);
        EXPECT_EQ(InclusionSet(kOblique, circular_inclusions(circles, 1)).size(), 30);
    }
}

TEST(RandomCircles, DependOnTheSeedAlone) {
    const Lattice unit = Lattice::rectangle(1, 1);
    const auto centre = [&](std::uint64_t seed) {
        return random_circles(unit, {.fraction = 0.5, .n = 30}, seed)[7].centre;
    };
    EXPECT_EQ(centre(1), centre(1));
    EXPECT_NE(centre(1), centre(2));
    // The same bits on every machine.
    EXPECT_EQ(centre(1).x(), 0x1.d76a8e131373ep-1);
    EXPECT_EQ(centre(1).y(), 0x1.ffd391fabc1f2p-1);
}

TEST(RandomCircles, MayBeOneAndFillTheSquare) {
    const Lattice unit = Lattice::rectangle(1, 1);
    EXPECT_EQ(random_circles(unit, {.fraction = 0.7, .n = 1}, 0).size(), 1u);
    EXPECT_THROW(random_circles(unit, {.fraction = 0.79, .n = 1}, 0), InvalidInput);
    EXPECT_THROW(random_circles(unit, {.fraction = 0.7, .n = 1, .gap = 0.2}, 0), InvalidInput);
}

TEST(RandomCircles, RefuseNumbersOutOfRange) {
    const Lattice unit = Lattice::rectangle(1, 1);
    for (const double fraction : {-0.1, 0.0, 1.0, std::nan("")}) {
        EXPECT_THROW(random_circles(unit, {.fraction = fraction, .n = 3}, 0), InvalidInput);
    }
    EXPECT_THROW(random_circles(unit, {.fraction = 0.3, .n = 0}, 0), InvalidInput);
    EXPECT_THROW(random_circles(unit, {.fraction = 0.3, .n = 3, .gap = 0}, 0), InvalidInput);
    EXPECT_THROW(random_circles(unit, {.fraction = 0.9, .n = 30}, 0), InvalidInput);
}

}  // namespace
}  // namespace pcvt::plane
