#pragma once

#include <algorithm>
#include <functional>
#include <numeric>
#include <utility>
#include <vector>

namespace pcvt {

/// Sorts `items` like std::sort by `less`, first into buckets by counting, then each bucket.
///
/// Linear where few items share a bucket; otherwise no slower than a sort of the whole by a
/// constant factor.
/// @param key  the bucket of an item, 0 ... n_keys - 1, which never falls where items rise.
template <class Item, class Key, class Less = std::less<>>
void bucket_sort(std::vector<Item>& items, int n_keys, Key key, Less less = {}) {
    // Two places ahead, so that placing the items leaves the beginnings of the buckets.
    std::vector<std::size_t> begin(static_cast<std::size_t>(n_keys) + 2, 0);
    for (const Item& item : items) ++begin[static_cast<std::size_t>(key(item)) + 2];
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    std::vector<Item> sorted(items.size());
    for (const Item& item : items) sorted[begin[static_cast<std::size_t>(key(item)) + 1]++] = item;
    for (std::size_t k = 0; k < static_cast<std::size_t>(n_keys); ++k) {
        if (begin[k + 1] - begin[k] < 2) continue;
        std::sort(sorted.begin() + std::ptrdiff_t(begin[k]),
                  sorted.begin() + std::ptrdiff_t(begin[k + 1]), less);
    }
    items = std::move(sorted);
}

}  // namespace pcvt
