#include "mesher/cells/elastic_constants.hpp"

#include <gmock/gmock.h>

#include "mesher/base/error.hpp"

namespace pcvt {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::string fault_of_numbers(const std::vector<double>& numbers) {
    try {
        checked_constants(numbers);
    } catch (const InvalidInput& fault) {
        return fault.what();
    }
    return {};
}

TEST(ElasticConstants, TheirNumberSaysWhichOnesTheyAre) {
    EXPECT_THAT(names_of(checked_constants({210000, 0.3})), ElementsAre("E", "nu"));
    EXPECT_THAT(names_of(checked_constants({231, 135, 116})), ElementsAre("C11", "C12", "C44"));
    EXPECT_THAT(names_of(checked_constants({162, 92, 69, 181, 47})),
                ElementsAre("C11", "C12", "C13", "C33", "C44"));
    EXPECT_EQ(constants_text({{210000, 0.3}}), "E 210000, nu 0.3");
    for (const int n : {0, 1, 4, 6}) {
        EXPECT_THAT(fault_of_numbers(std::vector<double>(n, 1.0)), HasSubstr("has 2, 3 or 5"));
    }
}

TEST(ElasticConstants, UnstableMaterialsAreRefused) {
    for (const auto& numbers : std::vector<std::vector<double>>{{0, 0.3},
                                                                {-1, 0.3},
                                                                {1, 0.5},
                                                                {1, -1},
                                                                {1, 1, 1},
                                                                {1, -0.6, 1},
                                                                {2, 1, 0},
                                                                {2, 1, 1, 0.5, 1},
                                                                {2, 1, 1, 1, 0},
                                                                {1, 2, 0, 1, 1},
                                                                {1e308 * 10, 0.3}}) {
        EXPECT_THAT(fault_of_numbers(numbers), HasSubstr("stable"))
            << ::testing::PrintToString(numbers);
    }
    for (const auto& numbers : std::vector<std::vector<double>>{
             {1, 0}, {1, -0.9}, {1, 0.499}, {2, 1, 0.1}, {2, -0.9, 3}, {2, 1, 1, 1, 1}}) {
        EXPECT_EQ(fault_of_numbers(numbers), "") << ::testing::PrintToString(numbers);
    }
}

TEST(ElasticConstants, IsotropicMaterialsHaveTheStiffnessOfLame) {
    const double e = 3.5;
    const double nu = 0.35;
    const auto [c11, c12, c13, c33, c44, c66] = stiffness_of({{e, nu}});
    EXPECT_NEAR(c11, e * (1 - nu) / ((1 + nu) * (1 - 2 * nu)), 1e-14);
    EXPECT_NEAR(c12, e * nu / ((1 + nu) * (1 - 2 * nu)), 1e-14);
    EXPECT_NEAR(c44, (c11 - c12) / 2, 1e-14);
    EXPECT_EQ(c13, c12);
    EXPECT_EQ(c33, c11);
    EXPECT_EQ(c66, c44);
    // Across the axis a hexagonal crystal is isotropic.
    const Stiffness titanium = stiffness_of({{162.4, 92, 69, 180.7, 46.7}});
    EXPECT_DOUBLE_EQ(titanium.c66, (titanium.c11 - titanium.c12) / 2);
}

}  // namespace
}  // namespace pcvt
