#include "mesher/base/bucket_sort.hpp"

#include <gtest/gtest.h>

#include <array>
#include <random>

namespace pcvt {
namespace {

TEST(BucketSort, SortsLikeStdSortForAnyBucketSize) {
    std::mt19937_64 random(1);
    for (const int n_keys : {1, 2, 50, 5000}) {
        std::vector<std::array<int, 2>> items(1000);
        for (auto& item : items) item = {int(random() % n_keys), int(random() % 100)};
        std::vector<std::array<int, 2>> sorted = items;
        std::sort(sorted.begin(), sorted.end());
        bucket_sort(items, n_keys, [](const auto& item) { return item[0]; });
        EXPECT_EQ(items, sorted);
    }
}

TEST(BucketSort, LeavesAnEmptyRangeEmpty) {
    std::vector<int> none;
    bucket_sort(none, 0, [](int item) { return item; });
    EXPECT_TRUE(none.empty());
}

TEST(BucketSort, VisitsEachBucketOnceInOrderOfTheKeys) {
    const std::vector<int> key{3, 0, 3, 5, 0, 3};
    std::vector<std::vector<int>> seen;
    for_each_bucket(
        6, 7, [&](int k) { return key[k]; },
        [&](std::span<const int> items) { seen.emplace_back(items.begin(), items.end()); });
    EXPECT_EQ(seen, (std::vector<std::vector<int>>{{1, 4}, {0, 2, 5}, {3}}));
    for_each_bucket(
        0, 0, [](int) { return 0; }, [](std::span<const int>) { ADD_FAILURE(); });
}

}  // namespace
}  // namespace pcvt
