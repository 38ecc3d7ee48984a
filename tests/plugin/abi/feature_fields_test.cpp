#include "plugin/abi/feature_fields.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <sstream>

namespace pcvt::abi {
namespace {

TEST(FeatureFields, FeaturesAreInTheOrderOfTheirEnumerators) {
    unsigned k = 0;
    for (const FeatureRow& row : features()) EXPECT_EQ(static_cast<unsigned>(row.feature), k++);
}

TEST(FeatureFields, FieldsAreThoseThatFeaturesName) {
    std::set<std::string> named;
    for (const FeatureRow& row : features()) {
        std::istringstream words{std::string(row.fields)};
        for (std::string word; words >> word;) EXPECT_TRUE(named.insert(word).second) << word;
    }
    std::set<std::string> listed;
    for (const auto& field : kOptionFields) EXPECT_TRUE(listed.insert(field.name).second);
    for (const auto& field : kWriteFields) EXPECT_TRUE(listed.insert(field.name).second);
    EXPECT_EQ(named, listed);
}

TEST(FeatureFields, FeaturesOfBothDimensionsHaveNoFieldToRefuse) {
    for (const FeatureRow& row : features()) {
        EXPECT_TRUE(row.in_plane || row.in_space) << row.option;
        if (row.in_plane && row.in_space) {
            EXPECT_EQ(row.fields, "") << row.option;
            EXPECT_EQ(row.option, "");
        }
    }
}

TEST(FeatureFields, AWordFindsItsRow) {
    for (const FeatureRow& row : features()) {
        if (!row.option.empty()) {
            EXPECT_EQ(find_option(row.option), &row);
        }
    }
    EXPECT_EQ(find_option("--threads"), nullptr);
    EXPECT_EQ(find_field("n_threads"), nullptr);
    EXPECT_EQ(find_field("areas")->feature, Feature::kAreas);
    EXPECT_EQ(find_field("n_areas")->feature, Feature::kAreas);
    EXPECT_EQ(find_field("area"), nullptr);
}

TEST(FeatureFields, AnOptionSetsFieldsWhetherEveryJobHasItOrNot) {
    using testing::ElementsAre;
    EXPECT_THAT(option_fields("--threads"), ElementsAre("n_threads"));
    EXPECT_THAT(option_fields("--lattice"), ElementsAre("lattice", "lattice3"));
    EXPECT_THAT(option_fields("--areas"), ElementsAre("areas", "n_areas", "area_law"));
    EXPECT_THAT(option_fields("--quiet"), ElementsAre());
}

}  // namespace
}  // namespace pcvt::abi
