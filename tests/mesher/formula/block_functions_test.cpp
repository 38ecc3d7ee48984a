#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

#include "mesher/formula/block_angles.hpp"
#include "mesher/formula/block_exponentials.hpp"
#include "mesher/formula/block_hyperbolics.hpp"

namespace pcvt {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr int kPoints = 1'000'000;
constexpr int kBlock = 200;

/// The distance of two numbers in units of the last place of the second one.
double units_between(double found, long double expected) {
    if (std::isnan(found) || std::isnan(expected)) {
        return std::isnan(found) && std::isnan(expected) ? 0 : kInfinity;
    }
    const auto rounded = static_cast<double>(expected);
    if (std::isinf(found) || std::isinf(rounded)) return found == rounded ? 0 : kInfinity;
    if (found == 0 && expected == 0) return std::signbit(found) == std::signbit(expected) ? 0 : 9;
    const int exponent = std::max(std::ilogb(expected), -1022);
    return static_cast<double>(std::abs(found - expected) / std::ldexp(1.0L, exponent - 52));
}

constexpr double kSpecials[] = {0,
                                0.5,
                                1,
                                0x1.0000000000001p0,
                                0x1.fffffffffffffp-1,
                                2,
                                3,
                                10,
                                22,
                                710,
                                745.2,
                                1e22,
                                1e308,
                                0x1.fffffffffffffp+1023,
                                5e-324,
                                0x1p-1023,
                                0x1p-1022,
                                kInfinity,
                                std::numeric_limits<double>::quiet_NaN()};

/// Numbers of all sizes and signs, the special ones among them, and numbers that are uniform in
/// some ranges.
class Arguments {
   public:
    explicit Arguments(int seed) : random_(seed) {}

    double next() {
        switch (count_++ % 5) {
            case 0:
                return count_ % 100 == 1 ? special() : std::bit_cast<double>(random_());
            case 1:
                return uniform(-1.5, 1.5);
            case 2:
                return uniform(-30, 30);
            case 3:
                return uniform(-800, 800);
            default:
                return std::ldexp(uniform(-1, 1), static_cast<int>(uniform(-60, 60)));
        }
    }
    double special() {
        const double x = kSpecials[random_() % std::size(kSpecials)];
        return random_() % 2 == 0 ? x : -x;
    }
    double uniform(double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random_);
    }

   private:
    std::mt19937_64 random_;
    int count_ = 0;
};

using Reference = long double(long double);

void expect_close(const char* name, BlockFunction* f, Reference* reference, double limit) {
    Arguments arguments(1);
    std::vector<double> x(kBlock);
    std::vector<double> y(kBlock);
    double worst = 0;
    double worst_at = 0;
    for (int from = 0; from < kPoints; from += kBlock) {
        for (double& one : x) one = arguments.next();
        f(x.data(), y.data(), kBlock);
        for (int k = 0; k < kBlock; ++k) {
            const double units = units_between(y[k], reference(x[k]));
            if (units > worst) {
                worst = units;
                worst_at = x[k];
            }
        }
    }
    EXPECT_LE(worst, limit) << name << "(" << worst_at << ") is " << one_of_block(f, worst_at)
                            << ", not " << reference(worst_at);
}

TEST(BlockFunctions, ErrorsAreAtMostTwoUnitsInTheLastPlace) {
    expect_close("exp", block_exp, expl, 2);
    expect_close("log", block_log, logl, 2);
    expect_close("log2", block_log2, log2l, 2);
    expect_close("log10", block_log10, log10l, 2);
    expect_close("cbrt", block_cbrt, cbrtl, 2);
    expect_close("sqrt", block_sqrt, sqrtl, 0.5001);
    expect_close("sinh", block_sinh, sinhl, 2);
    expect_close("cosh", block_cosh, coshl, 2);
    expect_close("tanh", block_tanh, tanhl, 2);
    expect_close("asinh", block_asinh, asinhl, 2);
    expect_close("acosh", block_acosh, acoshl, 2);
    expect_close("atanh", block_atanh, atanhl, 2);
    expect_close("sin", block_sin, sinl, 2);
    expect_close("cos", block_cos, cosl, 2);
    expect_close("tan", block_tan, tanl, 2);
    expect_close("asin", block_asin, asinl, 2);
    expect_close("acos", block_acos, acosl, 2);
    expect_close("atan", block_atan, atanl, 2);
}

TEST(BlockFunctions, AnglesNearQuarterTurnsKeepTheirDigits) {
    std::mt19937_64 random(4);
    constexpr long double kQuarter = 1.57079632679489661923L;
    std::vector<double> x{6381956970095103 * 0x1p797};  // the nearest of all to a quarter turn
    for (int k = 0; k < 20'000; ++k) {
        // Up to a million the angles are reduced in lanes, beyond one by one.
        const auto n = static_cast<long double>(random() % (k % 2 == 0 ? 600'000u : 100'000'000u));
        x.push_back(static_cast<double>(n * kQuarter));
    }
    for (const double one : x) {
        ASSERT_LE(units_between(one_of_block(block_sin, one), sinl(one)), 1) << one;
        ASSERT_LE(units_between(one_of_block(block_cos, one), cosl(one)), 1) << one;
        ASSERT_LE(units_between(one_of_block(block_tan, one), tanl(one)), 2) << one;
    }
}

using Reference2 = long double(long double, long double);

void expect_close(const char* name, BlockFunction2* f, Reference2* reference, double limit) {
    Arguments first(1);
    Arguments second(2);
    double worst = 0;
    double worst_at[2] = {0, 0};
    for (int n = 0; n < kPoints; n += kBlock) {
        std::vector<double> a(kBlock);
        std::vector<double> b(kBlock);
        std::vector<double> y(kBlock);
        for (int k = 0; k < kBlock; ++k) {
            a[k] = first.next();
            b[k] = k % 7 == 0 ? std::round(second.next()) : second.next();
            // A power near the limits of the numbers.
            if (k % 3 == 0) b[k] = second.uniform(-750, 750) / std::log(std::abs(a[k]));
        }
        f(a.data(), b.data(), y.data(), kBlock);
        for (int k = 0; k < kBlock; ++k) {
            const double units = units_between(y[k], reference(a[k], b[k]));
            if (!(units > worst)) continue;
            worst = units;
            worst_at[0] = a[k];
            worst_at[1] = b[k];
        }
    }
    EXPECT_LE(worst, limit) << name << "(" << worst_at[0] << ", " << worst_at[1] << ") is "
                            << one_of_block(f, worst_at[0], worst_at[1]) << ", not "
                            << reference(worst_at[0], worst_at[1]);
}

TEST(BlockFunctions, ErrorsOfPairsAreAtMostTwoUnitsInTheLastPlace) {
    expect_close("pow", block_pow, powl, 1);
    expect_close("atan2", block_atan2, atan2l, 2);
}

// Blocks of positive normal numbers have loops of their own.
TEST(BlockFunctions, PowersDoNotDependOnTheirNeighbours) {
    Arguments arguments(3);
    for (int round = 0; round < 300; ++round) {
        std::vector<double> a(kBlock);
        std::vector<double> b(kBlock);
        for (int k = 0; k < kBlock; ++k) {
            a[k] = round % 2 == 0 ? arguments.uniform(0.01, 3)
                                  : std::exp2(arguments.uniform(-1021.9, 1023.9));
            b[k] = arguments.uniform(-707, 707) / std::log(a[k]);
        }
        std::vector<double> alone(kBlock);
        block_pow(a.data(), b.data(), alone.data(), kBlock);
        for (int k = 0; k < kBlock; ++k) {
            ASSERT_LE(units_between(alone[k], powl(a[k], b[k])), 1) << a[k] << " ^ " << b[k];
        }
        // Some numbers that need the other loops.
        for (int k = round % 64; k < kBlock; k += 64) {
            (round % 3 == 0 ? b : a)[k] = arguments.special();
        }
        std::vector<double> among(kBlock);
        block_pow(a.data(), b.data(), among.data(), kBlock);
        for (int k = 0; k < kBlock; ++k) {
            ASSERT_EQ(std::bit_cast<std::uint64_t>(among[k]),
                      std::bit_cast<std::uint64_t>(one_of_block(block_pow, a[k], b[k])))
                << a[k] << " ^ " << b[k];
        }
    }
}

TEST(BlockFunctions, SpecialPairsGiveTheResultsOfTheLibrary) {
    for (const double a : kSpecials) {
        for (const double b : kSpecials) {
            for (const auto& [x, y] : {std::pair{a, b}, {-a, b}, {a, -b}, {-a, -b}}) {
                EXPECT_LE(units_between(one_of_block(block_pow, x, y), powl(x, y)), 1)
                    << x << " ^ " << y;
                EXPECT_LE(units_between(one_of_block(block_atan2, x, y), atan2l(x, y)), 2)
                    << "atan2(" << x << ", " << y << ")";
            }
        }
    }
}

TEST(BlockFunctions, ShortResultsAreExact) {
    for (int k = -1074; k <= 1023; ++k) {
        EXPECT_EQ(one_of_block(block_log2, std::ldexp(1, k)), k);
        EXPECT_EQ(one_of_block(block_pow, 2, k), std::ldexp(1, k));
    }
    for (int k = 0; k <= 22; ++k) EXPECT_EQ(one_of_block(block_log10, std::pow(10, k)), k);
    for (int k = 1; k < 10'000; ++k) {
        const double x = k;
        ASSERT_EQ(one_of_block(block_cbrt, x * x * x), x);
        ASSERT_EQ(one_of_block(block_pow, x, 2), x * x);
        ASSERT_EQ(one_of_block(block_pow, -x, 3), -x * x * x);
        ASSERT_EQ(one_of_block(block_pow, x * x, 1.5), x * x * x);
    }
}

}  // namespace
}  // namespace pcvt
