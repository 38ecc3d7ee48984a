#include "io/bytes/readable_number.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <limits>

namespace pcvt {
namespace {

TEST(ReadableNumber, IsThatOfPrintfWithSixDigits) {
    constexpr double kMost = std::numeric_limits<double>::max();
    for (const double value : {0.0, -0.0, 1.0, 0.1, 1 / 3.0, 1e6, 123456.7, 1e-5, -2.5e-300, kMost,
                               std::numeric_limits<double>::infinity()}) {
        std::array<char, 32> text;
        std::snprintf(text.data(), text.size(), "%.6g", value);
        EXPECT_EQ(figure(value), text.data());
    }
}

TEST(ReadableNumber, CountsThingsInTheSingularOnlyForOne) {
    EXPECT_EQ(counted(0, "cell") + counted(1, "cell") + counted(2, "cell"), "0 cells1 cell2 cells");
}

}  // namespace
}  // namespace pcvt
