#pragma once

#include <algorithm>
#include <functional>
#include <numeric>
#include <utility>
#include <vector>

namespace pcvt {

/// Sorts `items` by `less`, as std::sort does: a counting sort into buckets, then std::sort within
/// each bucket.
///
/// The cost is linear where few items share a bucket, and otherwise at most a constant factor above
/// one sort of all items.
///
/// Example usage (edges by their lower vertex):
///
///     bucket_sort(edges, n_vertices, [](const Edge& e) { return e.low; });
///
/// @param key  the bucket of an item, 0 ... n_keys - 1; must not decrease from an item to a greater
///             one.
template <class Item, class Key, class Less = std::less<>>
void bucket_sort(std::vector<Item>& items, int n_keys, Key key, Less less = {}) {
    // The counts are shifted by two entries: after the scatter begin[k] is the beginning of bucket
    // k.
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
