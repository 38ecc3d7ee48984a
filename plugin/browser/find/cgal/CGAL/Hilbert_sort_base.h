// In place of CGAL's header of this name, whose hilbert_split() calls std::nth_element: each standard library leaves the
// other elements in an order of its own, in which CGAL then inserts them. This split leaves the order of libstdc++, so
// that a triangulation numbers its triangles as in the native build.
#ifndef CGAL_HILBERT_SORT_BASE_H
#define CGAL_HILBERT_SORT_BASE_H

#include <CGAL/algorithm.h>
#include <CGAL/config.h>
#include <CGAL/use.h>

#include <algorithm>
#include <utility>

namespace CGAL {
namespace internal {

template <class Iterator, class Less>
void move_median_to_first(Iterator first, Iterator a, Iterator b, Iterator c, Less less) {
    if (less(*a, *b)) {
        std::iter_swap(first, less(*b, *c) ? b : less(*a, *c) ? c : a);
    } else {
        std::iter_swap(first, less(*a, *c) ? a : less(*b, *c) ? c : b);
    }
}

/// Hoare's partition round *pivot, which lies before `first`.
template <class Iterator, class Less>
Iterator partition_round(Iterator first, Iterator last, Iterator pivot, Less less) {
    for (;;) {
        while (less(*first, *pivot)) ++first;
        --last;
        while (less(*pivot, *last)) --last;
        if (!(first < last)) return first;
        std::iter_swap(first, last);
        ++first;
    }
}

template <class Iterator, class Less>
void insertion_sort(Iterator first, Iterator last, Less less) {
    for (Iterator it = first; it != last; ++it) {
        auto value = std::move(*it);
        Iterator to = it;
        for (; to != first && less(value, *(to - 1)); --to) *to = std::move(*(to - 1));
        *to = std::move(value);
    }
}

template <class Iterator, class Less>
void select(Iterator first, Iterator nth, Iterator last, Less less) {
    int depth = 0;
    for (auto n = last - first; n > 1; n /= 2) depth += 2;
    while (last - first > 3) {
        if (depth-- == 0) {
            std::nth_element(first, nth, last, less);
            return;
        }
        move_median_to_first(first, first + 1, first + (last - first) / 2, last - 1, less);
        const Iterator cut = partition_round(first + 1, last, first, less);
        (cut <= nth ? first : last) = cut;
    }
    insertion_sort(first, last, less);
}

template <class Iterator, class Less>
Iterator hilbert_split(Iterator begin, Iterator end, Less less = Less()) {
    if (begin >= end) return begin;
    const Iterator middle = begin + (end - begin) / 2;
    select(begin, middle, end, less);
    return middle;
}

}  // namespace internal
}  // namespace CGAL

#endif
