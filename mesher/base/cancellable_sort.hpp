#pragma once

#include <algorithm>
#include <functional>

#include "mesher/base/checkpoint.hpp"

namespace pcvt {

/// std::sort and std::stable_sort with checkpoints, for arrays of more than some 10^5 items.
///
///     cancellable_sort(edges.begin(), edges.end());
template <class Iterator, class Less = std::less<>>
void cancellable_sort(Iterator first, Iterator last, Less less = {}) {
    long n_compared = 0;
    std::sort(first, last, [&](const auto& one, const auto& other) {
        checkpoint_each(++n_compared, 1 << 14);
        return less(one, other);
    });
}

template <class Iterator, class Less = std::less<>>
void cancellable_stable_sort(Iterator first, Iterator last, Less less = {}) {
    long n_compared = 0;
    std::stable_sort(first, last, [&](const auto& one, const auto& other) {
        checkpoint_each(++n_compared, 1 << 14);
        return less(one, other);
    });
}

}  // namespace pcvt
