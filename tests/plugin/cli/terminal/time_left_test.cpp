#include "plugin/cli/terminal/time_left.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace pcvt::cli {
namespace {

/// Returns the estimate for a residual that falls by the factor e every `e_fold` seconds, sampled
/// ten times per second.
TimeLeft seen_falling(double e_fold, double until) {
    TimeLeft time_left;
    for (double t = 0; t <= until; t += 0.1) time_left.add(t, std::exp(-t / e_fold));
    return time_left;
}

TEST(TimeLeft, GeometricDecayIsPredictedExactly) {
    const std::optional<double> left = seen_falling(2, 10).until(std::exp(-10));
    ASSERT_TRUE(left.has_value());
    EXPECT_NEAR(*left, 10, 0.11);
}

TEST(TimeLeft, TheLaterHalfDecides) {
    TimeLeft time_left;
    for (double t = 0; t < 5; t += 0.1) time_left.add(t, std::exp(-10 * t));
    for (double t = 5; t < 30; t += 0.1) time_left.add(t, std::exp(-50 - (t - 5)));
    EXPECT_NEAR(time_left.until(std::exp(-85)).value(), 10, 0.2);
}

TEST(TimeLeft, AReachedTargetTakesNoTime) { EXPECT_EQ(seen_falling(1, 10).until(0.5).value(), 0); }

TEST(TimeLeft, NothingIsPredictedWhereNothingFalls) {
    TimeLeft flat;
    TimeLeft rising;
    for (int i = 0; i < 100; ++i) {
        flat.add(i, 1);
        rising.add(i, std::exp(i));
    }
    EXPECT_FALSE(flat.until(1e-6).has_value());
    EXPECT_FALSE(rising.until(1e-6).has_value());
    EXPECT_FALSE(TimeLeft().until(1e-6).has_value());
}

TEST(TimeLeft, ZerosAndInfinitiesAreIgnored) {
    TimeLeft time_left = seen_falling(2, 10);
    time_left.add(10.1, 0);
    time_left.add(10.2, HUGE_VAL);
    EXPECT_NEAR(time_left.until(std::exp(-10)).value(), 10, 0.11);
}

TEST(TimeLeft, LongRunsArePredictedToo) {
    EXPECT_NEAR(seen_falling(50, 1000).until(std::exp(-30)).value(), 500, 1);
}

}  // namespace
}  // namespace pcvt::cli
