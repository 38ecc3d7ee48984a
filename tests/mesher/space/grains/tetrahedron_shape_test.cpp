#include "mesher/space/grains/tetrahedron_shape.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "tests/support/random_numbers.hpp"

namespace pcvt::space {
namespace {

Vec3 random_point(std::mt19937_64& random) {
    const double x = testing::random_number(random);
    const double y = testing::random_number(random);
    return {x, y, testing::random_number(random)};
}

/// Four random points, positively oriented.
std::array<Vec3, 4> random_tetrahedron(std::mt19937_64& random) {
    for (;;) {
        const Vec3 a = random_point(random);
        const Vec3 b = random_point(random);
        const Vec3 c = random_point(random);
        const Vec3 d = random_point(random);
        if (volume6(a, b, c, d) > 1e-3) return {a, b, c, d};
    }
}

TEST(TetrahedronShape, RegularTetrahedronHasEqualAngles) {
    const Vec3 a(1, 1, 1);
    const Vec3 b(-1, 1, -1);
    const Vec3 c(1, -1, -1);
    const Vec3 d(-1, -1, 1);
    EXPECT_NEAR(volume6(a, b, c, d), 16, 1e-12);
    const DihedralRange range = dihedral_range(a, b, c, d);
    EXPECT_NEAR(range.smallest, std::acos(1.0 / 3) * 180 / std::numbers::pi, 1e-12);
    EXPECT_NEAR(range.largest, range.smallest, 1e-12);
    EXPECT_NEAR(smallest_sine(a, b, c, d), std::sqrt(8.0) / 3, 1e-15);
    EXPECT_NEAR(smallest_sine(a, c, b, d), -std::sqrt(8.0) / 3, 1e-15);
}

TEST(TetrahedronShape, SmallestSineIsThatOfTheDihedralAngles) {
    std::mt19937_64 random(1);
    for (int k = 0; k < 1000; ++k) {
        const auto [a, b, c, d] = random_tetrahedron(random);
        const DihedralRange range = dihedral_range(a, b, c, d);
        const double angle = std::min(range.smallest, 180 - range.largest);
        EXPECT_NEAR(smallest_sine(a, b, c, d), std::sin(angle / 180 * std::numbers::pi), 1e-9);
    }
}

TEST(TetrahedronShape, SphereHoldsWhatIsNearerThanItsRadius) {
    std::mt19937_64 random(2);
    for (int k = 0; k < 1000; ++k) {
        const auto [a, b, c, d] = random_tetrahedron(random);
        const Circumsphere sphere = circumsphere(a, b, c, d);
        for (const Vec3& p : {a, b, c, d}) {
            EXPECT_NEAR(distance(p, sphere.centre), sphere.radius, 1e-8 * sphere.radius);
        }
        const Vec3 e = random_point(random);
        const double depth = sphere.radius - distance(e, sphere.centre);
        if (std::abs(depth) < 1e-6) continue;
        EXPECT_EQ(in_sphere(a, b, c, d, e) > 0, depth > 0);
    }
}

/// Raised where angles are small, and otherwise as it is, so that order and sign remain.
TEST(QualityAtFeature, RisesWithTheSine) {
    double before = -2;
    for (double sine = -1; sine <= 1; sine += 0.001) {
        const double quality = quality_at_feature(sine);
        EXPECT_GT(quality, before);
        EXPECT_GE(quality, sine);
        EXPECT_EQ(quality > sine + 1e-12, sine > 1e-9 && sine < 0.32 - 1e-9) << sine;
        before = quality;
    }
    EXPECT_EQ(quality_at_feature(-0.2), -0.2);
    EXPECT_GT(quality_at_feature(std::sin(1.5 / 180 * std::numbers::pi)),
              std::sin(10.0 / 180 * std::numbers::pi));
}

}  // namespace
}  // namespace pcvt::space
