#include "mesher/cells/target_areas.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "mesher/base/error.hpp"

namespace pcvt {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

TEST(TargetAreas, LawsHaveTheSpreadThatTheyName) {
    for (const char* const text : {"lognormal:0.1", "lognormal:0.42", "lognormal:0.8", "gamma:0.1",
                                   "gamma:0.42", "gamma:0.8", "gamma:1.2"}) {
        const AreaLaw law = parse_area_law(text);
        const double spread = diameter_spread(draw_areas(law, 200'000, 1));
        EXPECT_NEAR(spread, law.components[0].spread, 0.015 * law.components[0].spread) << text;
    }
    EXPECT_EQ(diameter_spread(draw_areas(parse_area_law("equal"), 10, 1)), 0);
}

// The third moment distinguishes the two laws: skewness 3 S + S^3 of the lognormal, 2 S of the
// gamma.
TEST(TargetAreas, LawsHaveTheirSkewness) {
    const auto skewness = [](const char* text) {
        const Eigen::ArrayXd d = draw_areas(parse_area_law(text), 400'000, 3).array().sqrt();
        const Eigen::ArrayXd x = d - d.mean();
        return x.cube().mean() / std::pow(x.square().mean(), 1.5);
    };
    EXPECT_NEAR(skewness("lognormal:0.42"), 3 * 0.42 + std::pow(0.42, 3), 0.05);
    EXPECT_NEAR(skewness("gamma:0.42"), 2 * 0.42, 0.03);
}

TEST(TargetAreas, ASeedGivesTheSameBitsOnEveryMachine) {
    const Eigen::VectorXd lognormal = draw_areas(parse_area_law("lognormal:0.42"), 3, 7);
    const Eigen::VectorXd gamma = draw_areas(parse_area_law("gamma:0.42"), 3, 7);
    EXPECT_EQ(lognormal, draw_areas(parse_area_law("lognormal:0.42"), 3, 7));
    EXPECT_NE(lognormal, draw_areas(parse_area_law("lognormal:0.42"), 3, 8));
    EXPECT_EQ(lognormal[2], 0x1.1d31faf60c96ep+1);
    EXPECT_EQ(gamma[2], 0x1.e7d129b3af932p+4);
}

TEST(TargetAreas, AreScaledToTheDomain) {
    Eigen::VectorXd given(3);
    given << 1e308, 1.5e308, 1e308;
    const Eigen::VectorXd areas = scaled_areas(given, 3, 7);
    EXPECT_NEAR(areas.sum(), 7, 1e-14);
    EXPECT_NEAR(areas[1] / areas[0], 1.5, 1e-14);
}

TEST(TargetAreas, ImpossibleTargetsAreRefusedInOneLine) {
    Eigen::VectorXd given = Eigen::VectorXd::Ones(3);
    const auto scaled = [&] { scaled_areas(given, 3, 1); };
    for (const double bad : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN(),
                             std::numeric_limits<double>::infinity()}) {
        given[1] = bad;
        EXPECT_THAT(scaled, ThrowsMessage<InvalidInput>(HasSubstr("the area of site 1 is")));
    }
    given[1] = 1e-7;
    EXPECT_THAT(scaled, ThrowsMessage<InvalidInput>(HasSubstr("1.5e-07 of the mean")));
    given = areas_of_diameters(-Eigen::VectorXd::Ones(3));
    EXPECT_THAT(scaled, ThrowsMessage<InvalidInput>(HasSubstr("the area of site 0 is")));
    given = Eigen::VectorXd::Ones(2);
    EXPECT_THAT(scaled, ThrowsMessage<InvalidInput>(HasSubstr("2 areas for 3 sites")));
}

// The numbers of cells with each law are the shares of all, rounded to the nearest with the sum n.
TEST(TargetAreas, MixturesKeepTheSharesOfTheNumber) {
    const AreaLaw law = parse_area_law("0.7*equal@1+0.2*equal@2+0.1*equal@3");
    for (int n = 1; n <= 60; ++n) {
        const Eigen::ArrayXd diameters = draw_areas(law, n, n).array().sqrt();
        const double unit = std::sqrt(areas_of_diameters(Eigen::VectorXd::Ones(1))[0]);
        int sum = 0;
        for (const LawComponent& component : law.components) {
            const auto count =
                static_cast<int>(((diameters / unit - component.mean).abs() < 1e-12).count());
            EXPECT_LT(std::abs(count - component.share * n), 1) << n;
            sum += count;
        }
        EXPECT_EQ(sum, n);
    }
    EXPECT_NE(draw_areas(law, 60, 1), draw_areas(law, 60, 2));
}

}  // namespace
}  // namespace pcvt
