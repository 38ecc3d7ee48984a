#include "mesher/portable/portable_functions.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace pcvt {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Positive numbers of every size.
std::vector<double> sizes() {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> exponent(-1020, 1020);
    std::vector<double> list;
    for (int k = 0; k < 50'000; ++k) list.push_back(std::exp2(exponent(random)));
    for (int k = 0; k < 50'000; ++k) list.push_back(std::exp2(exponent(random) / 1020));
    return list;
}

TEST(PortableFunctions, ExponentialAndLogarithmAgreeWithTheLibrary) {
    for (double x = -300; x < 300; x += 0.37) {
        EXPECT_NEAR(portable_exp(x) / std::exp(x), 1, 4e-15 * (1 + std::abs(x) / 100)) << x;
    }
    for (const double x : sizes()) {
        ASSERT_NEAR(portable_log(x), std::log(x), 4e-15 * std::abs(std::log(x))) << x;
        ASSERT_NEAR(portable_log2(x), std::log2(x), 4e-15 * std::abs(std::log2(x))) << x;
        ASSERT_NEAR(portable_log10(x), std::log10(x), 4e-15 * std::abs(std::log10(x))) << x;
    }
    for (int k = -1074; k <= 1023; ++k) EXPECT_EQ(portable_log2(std::ldexp(1, k)), k);
    EXPECT_EQ(portable_exp(0), 1);
    EXPECT_EQ(portable_exp(-kInfinity), 0);
    EXPECT_EQ(portable_exp(kInfinity), kInfinity);
    EXPECT_EQ(portable_exp(1000), kInfinity);
    EXPECT_NEAR(portable_exp(709.7) / std::exp(709.7), 1, 1e-13);
    EXPECT_NEAR(portable_exp(-744), std::exp(-744), 5e-324);
    EXPECT_TRUE(std::isnan(portable_exp(std::nan(""))));
    for (const auto log : {portable_log, portable_log2, portable_log10}) {
        EXPECT_EQ(log(1), 0);
        EXPECT_EQ(log(0), -kInfinity);
        EXPECT_EQ(log(kInfinity), kInfinity);
        EXPECT_TRUE(std::isnan(log(-1)));
        EXPECT_TRUE(std::isnan(log(std::nan(""))));
    }
}

TEST(PortableFunctions, CubeRootsAreExactForCubes) {
    for (const double x : sizes()) {
        ASSERT_NEAR(static_cast<double>(portable_cbrt(x) / std::cbrt(static_cast<long double>(x))),
                    1, 3e-16)
            << x;
        ASSERT_EQ(portable_cbrt(-x), -portable_cbrt(x));
    }
    for (int k = 0; k < 100'000; ++k) {
        ASSERT_EQ(portable_cbrt(double(k) * k * k), k);
    }
    EXPECT_NEAR(portable_cbrt(5e-324) / std::cbrt(5e-324), 1, 4.5e-16);
    EXPECT_TRUE(std::signbit(portable_cbrt(-0.0)));
    EXPECT_EQ(portable_cbrt(-kInfinity), -kInfinity);
    EXPECT_TRUE(std::isnan(portable_cbrt(std::nan(""))));
}

}  // namespace
}  // namespace pcvt
