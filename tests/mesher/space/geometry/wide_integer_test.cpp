#include "mesher/space/geometry/wide_integer.hpp"

#include <gtest/gtest.h>

#include <random>

namespace pcvt::space {
namespace {

__extension__ using Int128 = __int128;
__extension__ using Unsigned128 = unsigned __int128;

Int128 value(const WideInteger<2>& x) {
    return static_cast<Int128>((static_cast<Unsigned128>(x.word(1)) << 64) | x.word(0));
}

int sign(Int128 x) { return (x > 0) - (x < 0); }

TEST(WideInteger, AgreesWithTheIntegersOfTheCompiler) {
    std::mt19937_64 random(1);
    for (int k = 0; k < 10'000; ++k) {
        const auto x = static_cast<std::int64_t>(random()) >> (random() % 64);
        const auto y = static_cast<std::int64_t>(random()) >> (random() % 64);
        const WideInteger<2> a(x);
        const WideInteger<2> b(y);
        EXPECT_TRUE(value(a + b) == Int128{x} + y);
        EXPECT_TRUE(value(a - b) == Int128{x} - y);
        EXPECT_TRUE(value(a * b) == Int128{x} * y);
        EXPECT_EQ((a - b).sign(), sign(Int128{x} - y));
        EXPECT_EQ((a * b).sign(), sign(x) * sign(y));
    }
}

/// (x y - z) (x y + z) = x^2 y^2 - z^2, in more than one width.
TEST(WideInteger, LongProductsAndSumsAreExact) {
    std::mt19937_64 random(2);
    for (int k = 0; k < 10'000; ++k) {
        const auto draw = [&] { return static_cast<std::int64_t>(random()) >> (random() % 64); };
        const WideInteger<3> x(draw());
        const WideInteger<3> y(draw());
        const WideInteger<3> z(draw());
        const WideInteger<6> product = WideInteger<6>(x * y - z) * WideInteger<6>(x * y + z);
        const WideInteger<6> xx = WideInteger<6>(x) * WideInteger<6>(x);
        const WideInteger<6> yy = WideInteger<6>(y) * WideInteger<6>(y);
        const WideInteger<6> zz = WideInteger<6>(z) * WideInteger<6>(z);
        EXPECT_EQ((product - (xx * yy - zz)).sign(), 0);
        EXPECT_EQ((product + WideInteger<6>(1) - (xx * yy - zz)).sign(), 1);
    }
}

}  // namespace
}  // namespace pcvt::space
