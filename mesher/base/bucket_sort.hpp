#pragma once

#include <algorithm>
#include <functional>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include "mesher/base/checkpoint.hpp"

namespace pcvt {

namespace detail {
/// Items that are counted or scattered between two checkpoints.
inline constexpr long kScattered = 1 << 14;
}  // namespace detail

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
    for (std::size_t k = 0; k < items.size(); ++k) {
        checkpoint_each(static_cast<long>(k), detail::kScattered);
        sorted[begin[static_cast<std::size_t>(key(items[k])) + 1]++] = items[k];
    }
    for (std::size_t k = 0; k < static_cast<std::size_t>(n_keys); ++k) {
        checkpoint_each(static_cast<long>(k));
        if (begin[k + 1] - begin[k] < 2) continue;
        std::sort(sorted.begin() + std::ptrdiff_t(begin[k]),
                  sorted.begin() + std::ptrdiff_t(begin[k + 1]), less);
    }
    items = std::move(sorted);
}

/// Visits the items of each bucket, by rising key; takes one integer an item and one a key.
///
/// Example usage (the edges that leave each vertex):
///
///     for_each_bucket(n_edges, n_vertices, [&](int e) { return origin[e]; },
///                     [&](std::span<const int> leaving) { use(leaving); });
///
/// @param key    the bucket of an item, 0 ... n_keys - 1.
/// @param visit  takes the items of a bucket that is not empty, by rising number.
template <class Key, class Visit>
void for_each_bucket(int n_items, int n_keys, const Key& key, const Visit& visit) {
    // As above, the counts are shifted by two entries.
    std::vector<int> begin(static_cast<std::size_t>(n_keys) + 2, 0);
    for (int k = 0; k < n_items; ++k) {
        checkpoint_each(k, detail::kScattered);
        ++begin[static_cast<std::size_t>(key(k)) + 2];
    }
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    std::vector<int> items(static_cast<std::size_t>(n_items));
    for (int k = 0; k < n_items; ++k) {
        checkpoint_each(k, detail::kScattered);
        items[begin[static_cast<std::size_t>(key(k)) + 1]++] = k;
    }
    for (std::size_t k = 0; k < static_cast<std::size_t>(n_keys); ++k) {
        checkpoint_each(static_cast<long>(k));
        if (begin[k] == begin[k + 1]) continue;
        visit(std::span(items).subspan(begin[k], begin[k + 1] - begin[k]));
    }
}

}  // namespace pcvt
