#include "mesher/portable/portable_angles.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace pcvt {
namespace {

constexpr double kDegree = M_PI / 180;

TEST(PortableAngles, DegreesAgreeWithTheLibrary) {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> angle(-1000, 1000);
    for (int k = 0; k < 100'000; ++k) {
        const double degrees = k < 2000 ? k - 1000 : angle(random);
        const auto [cos, sin] = cos_sin_of_degrees(degrees);
        const double radians = std::fmod(degrees, 360) * kDegree;
        EXPECT_NEAR(cos, std::cos(radians), 2e-15) << degrees;
        EXPECT_NEAR(sin, std::sin(radians), 2e-15) << degrees;
        EXPECT_NEAR(cos * cos + sin * sin, 1, 1e-15) << degrees;
    }
}

TEST(PortableAngles, RightAnglesAreExact) {
    for (int k = -8; k <= 8; ++k) {
        const auto [cos, sin] = cos_sin_of_degrees(90.0 * k);
        EXPECT_EQ(cos, (k + 8) % 4 == 0 ? 1 : ((k + 8) % 4 == 2 ? -1 : 0)) << k;
        EXPECT_EQ(sin, (k + 8) % 4 == 1 ? 1 : ((k + 8) % 4 == 3 ? -1 : 0)) << k;
    }
    EXPECT_NEAR(cos_sin_of_degrees(60).cos, 0.5, 1.2e-16);
}

TEST(PortableAngles, ArcCosineAgreesWithTheLibrary) {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> exponent(-50, -1);
    for (int k = 0; k < 100'000; ++k) {
        double u = std::exp2(exponent(random));
        if (k % 2 == 1) u = 1 - u;
        const double wanted = 2 * std::asin(std::sqrt(u)) / kDegree;
        EXPECT_NEAR(degrees_of_cosine(u) / wanted, 1, k % 2 == 1 ? 1e-7 : 1e-15) << u;
        EXPECT_NEAR(cos_sin_of_degrees(degrees_of_cosine(u)).cos, 1 - 2 * u, 1e-15) << u;
    }
    EXPECT_EQ(degrees_of_cosine(0.5), 90);
}

TEST(PortableAngles, RadiansAgreeWithTheLibrary) {
    std::mt19937_64 random(2);
    for (const double largest : {1.0, 10.0, 99'999.0}) {
        std::uniform_real_distribution<double> angle(-largest, largest);
        for (int k = 0; k < 100'000; ++k) {
            // Every other angle lies close to a multiple of pi / 4.
            double radians = angle(random);
            if (k % 2 == 1) radians = std::round(radians / (M_PI / 4)) * (M_PI / 4);
            const auto [cos, sin] = cos_sin(radians);
            ASSERT_NEAR(cos, std::cos(radians), 4e-16) << radians;
            ASSERT_NEAR(sin, std::sin(radians), 4e-16) << radians;
            ASSERT_EQ(portable_cos(radians), cos);
            ASSERT_EQ(portable_sin(radians), sin);
            ASSERT_EQ(portable_tan(radians), sin / cos);
        }
    }
    EXPECT_EQ(portable_sin(0), 0);
    EXPECT_EQ(portable_cos(0), 1);
    EXPECT_LE(std::abs(portable_sin(1e300)), 1);
    EXPECT_TRUE(std::isnan(portable_cos(HUGE_VAL)));
    EXPECT_TRUE(std::isnan(portable_tan(std::nan(""))));
}

TEST(PortableAngles, InversesAgreeWithTheLibrary) {
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> uniform(-1, 1);
    for (int k = 0; k < 100'000; ++k) {
        const double x = uniform(random);
        const double y = uniform(random);
        ASSERT_NEAR(portable_acos(x), std::acos(x), 1e-15 * M_PI) << x;
        ASSERT_NEAR(portable_atan2(y, x), std::atan2(y, x), 1e-15 * M_PI) << y << " " << x;
    }
}

TEST(PortableAngles, SpecialValuesAreThoseOfTheLibrary) {
    const auto same = [](double one, double two) {
        return std::signbit(one) == std::signbit(two) &&
               (one == two || std::abs(one - two) < 1e-15);
    };
    for (const double y : {0.0, -0.0, 1.0, -1.0, HUGE_VAL, -HUGE_VAL}) {
        for (const double x : {0.0, -0.0, 1.0, -1.0, HUGE_VAL, -HUGE_VAL}) {
            EXPECT_TRUE(same(portable_atan2(y, x), std::atan2(y, x))) << y << " " << x;
        }
        if (std::abs(y) <= 1) {
            EXPECT_TRUE(same(portable_acos(y), std::acos(y))) << y;
        }
    }
    EXPECT_TRUE(std::isnan(portable_acos(-1.5)));
    EXPECT_TRUE(std::isnan(portable_atan2(1, std::nan(""))));
}

}  // namespace
}  // namespace pcvt
