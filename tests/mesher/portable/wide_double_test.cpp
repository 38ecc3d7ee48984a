#include "mesher/portable/wide_double.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <random>

namespace pcvt {
namespace {

using Exact = boost::multiprecision::cpp_bin_float_100;

Exact exact(const WideDouble& x) {
    const double high = static_cast<double>(x);
    return Exact(high) + Exact(static_cast<double>(x - high));
}

/// Numbers of all sizes, with digits beyond those of a double.
WideDouble random_number(std::mt19937_64& random) {
    std::uniform_real_distribution<double> uniform(-1, 1);
    const double high = std::ldexp(uniform(random), static_cast<int>(100 * uniform(random)));
    return WideDouble(high) + high * 0x1p-54 * uniform(random);
}

TEST(WideDouble, HasTwiceTheDigitsOfADouble) {
    std::mt19937_64 random(1);
    for (int k = 0; k < 20'000; ++k) {
        const WideDouble x = random_number(random);
        const WideDouble y = random_number(random);
        const Exact p = exact(x);
        const Exact q = exact(y);
        const Exact larger = abs(p) > abs(q) ? abs(p) : abs(q);
        ASSERT_LE(abs(exact(x + y) - (p + q)), larger * 1e-30);
        ASSERT_LE(abs(exact(x - y) - (p - q)), larger * 1e-30);
        ASSERT_LE(abs(exact(x * y) - p * q), abs(p * q) * 1e-30);
        ASSERT_LE(abs(exact(x / y) - p / q), abs(p / q) * 1e-30);
        ASSERT_EQ(exact(-x), -p);
    }
}

TEST(WideDouble, KeepsWhatDoublesLose) {
    const WideDouble one = 1;
    EXPECT_EQ(static_cast<double>((one + 1e-20) - one), 1e-20);
    EXPECT_EQ(static_cast<double>(one / 3 * 3 - one), 0);
    WideDouble sum = 2;
    sum *= 3;
    sum -= 1;
    sum /= 4;
    sum += 0x1p-70;
    EXPECT_EQ(static_cast<double>(sum), 1.25);
    EXPECT_EQ(static_cast<double>(sum - 1.25), 0x1p-70);
}

TEST(WideDouble, MakesMatricesOfEigen) {
    // The columns differ by 1e-12, so that doubles lose the determinant, 1e-24.
    Eigen::Matrix<WideDouble, 3, 3> matrix;
    matrix << 1, 1, 1, 1, WideDouble(1) + 1e-12, 1, 1, 1, WideDouble(1) + 1e-12;
    EXPECT_NEAR(static_cast<double>(matrix.determinant()) / 1e-24, 1, 1e-6);
    EXPECT_EQ(static_cast<double>(matrix.col(0).squaredNorm()), 3);
}

}  // namespace
}  // namespace pcvt
