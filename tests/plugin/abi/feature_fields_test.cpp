#include "plugin/abi/feature_fields.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <sstream>

#include "plugin/job/job.hpp"
#include "plugin/job/option_fields.hpp"

namespace pcvt::abi {
namespace {

TEST(FeatureFields, FeaturesAreInTheOrderOfTheirEnumerators) {
    unsigned k = 0;
    for (const FeatureRow& row : features()) EXPECT_EQ(static_cast<unsigned>(row.feature), k++);
}

TEST(FeatureFields, FieldsThatFeaturesAndNumbersNameAreThoseOfTheHeader) {
    std::set<std::string> listed;
    for (const auto& field : kOptionFields) EXPECT_TRUE(listed.insert(field.name).second);
    for (const auto& field : kWriteFields) listed.insert(field.name);
    std::set<std::string> named;
    for (const FeatureRow& row : features()) {
        std::istringstream words{std::string(row.fields)};
        for (std::string word; words >> word;) {
            EXPECT_TRUE(named.insert(word).second) << word;
            EXPECT_TRUE(listed.count(word)) << word;
        }
    }
    for (const NumberRow& row : number_options()) EXPECT_TRUE(listed.count(row.field)) << row.field;
}

template <class Fields>
std::ptrdiff_t count_numbers(const Fields& fields, const NumberRow& row) {
    return std::count_if(std::begin(fields), std::end(fields), [&](const auto& field) {
        return field.name == row.field && field.number.index() == (row.is_whole() ? 2 : 1);
    });
}

TEST(FeatureFields, EachNumberOptionHasOneFieldOfItsTypeInTheStructOfRunsOrOfFiles) {
    for (const NumberRow& row : number_options()) {
        EXPECT_EQ(count_numbers(kOptionFields, row), row.is_of_files() ? 0 : 1) << row.option;
        EXPECT_EQ(count_numbers(kWriteFields, row), row.is_of_files() ? 1 : 0) << row.option;
    }
}

TEST(FeatureFields, ANumberThatIsUnsetLeavesTheDefault) {
    pcvt_options options{};
    options.tolerance = 0.5;
    options.max_iterations = -7;
    Job job;
    job.tile.grain_size = 2;
    read_numbers(kOptionFields, options, job);
    EXPECT_EQ(job.run.tolerance, 0.5);
    EXPECT_EQ(job.run.max_iterations, Job().run.max_iterations);
    EXPECT_EQ(job.tile.grain_size, 2);
    options.max_iterations = 0;
    options.grain_size = 3;
    options.grain_per_edge = 4;
    read_numbers(kOptionFields, options, job);
    EXPECT_EQ(job.run.max_iterations, 0);
    EXPECT_EQ(job.tile.grain_size, 3);
    EXPECT_EQ(job.tile.grain_per_edge, 4);
    options.grain_per_edge = -1;
    EXPECT_THROW(read_numbers(kOptionFields, options, job), InvalidInput);
}

TEST(FeatureFields, EachFeatureBelongsToADimension) {
    for (const FeatureRow& row : features()) {
        EXPECT_TRUE(row.in_plane || row.in_space) << row.option;
    }
    EXPECT_TRUE(find_option("--phases")->in_space);
    EXPECT_FALSE(find_option("--walls")->in_space);
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
