#include "mesher/plane/delaunay/spatial_sort.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

#include "mesher/base/checkpoint.hpp"
#include "mesher/plane/geometry/sites.hpp"

namespace pcvt::plane {
namespace {

/// Bins above this size use std::sort instead of insertion sort.
constexpr int kSmallBin = 8;

/// Sorts ids by key(id) in [0, 1), ties by id: a counting sort into one bin per id, then a sort
/// within each bin.
template <class Key>
void sort_by_key(std::span<SiteId> ids, const Key& key) {
    const std::size_t n = ids.size();
    const auto bin = [&](SiteId s) {
        return static_cast<std::size_t>(key(s) * static_cast<double>(n));
    };
    // Count the ids of each bin and move them there, in their order.
    std::vector<int> end(n + 1, 0);
    for (const SiteId s : ids) ++end[bin(s)];
    std::partial_sum(end.begin(), end.end(), end.begin());
    const std::vector<SiteId> unsorted(ids.begin(), ids.end());
    for (std::size_t k = n; k-- > 0;) ids[--end[bin(unsorted[k])]] = unsorted[k];

    // Sort within the bins.
    const auto less = [&](SiteId s, SiteId t) {
        const double ks = key(s);
        const double kt = key(t);
        return ks < kt || (ks == kt && s < t);
    };
    // After the scatter end[k] is the beginning of bin k.
    for (std::size_t k = 0; k < n; ++k) {
        checkpoint_each(k);
        const auto first = ids.begin() + end[k];
        const auto last = ids.begin() + end[k + 1];
        if (last - first > kSmallBin) {
            std::sort(first, last, less);
            continue;
        }
        for (auto to = first; to != last; ++to) {
            std::rotate(std::upper_bound(first, to, *to, less), to, to + 1);
        }
    }
}

}  // namespace

int coordinate_across_columns(const Gram& gram) {
    constexpr double kLongerSquare = 4;
    return gram.bb > kLongerSquare * gram.aa ? 1 : 0;
}

SpatialSort spatial_sort(const Points& coordinates, const Gram& gram) {
    const auto n = static_cast<int>(coordinates.cols());
    SpatialSort columns;
    const int across = coordinate_across_columns(gram);
    columns.across = across;
    columns.order.resize(static_cast<std::size_t>(n));
    std::iota(columns.order.begin(), columns.order.end(), 0);
    sort_by_key(std::span(columns.order), [&](SiteId s) { return coordinates(across, s); });

    // The sites of a column divide the length l of a period, and the columns the area over l.
    const double area = std::sqrt(gram.aa * gram.bb - gram.ab * gram.ab);
    const double square = across == 0 ? gram.bb : gram.aa;
    const int n_columns = std::clamp(static_cast<int>(std::sqrt(n * area / square)), 1, n);
    for (int k = 0; k <= n_columns; ++k) {
        columns.begin.push_back(static_cast<int>(std::int64_t{n} * k / n_columns));
    }
    for (int k = 0; k < n_columns; ++k) {
        checkpoint();
        const auto ids = std::span(columns.order)
                             .subspan(columns.begin[k], columns.begin[k + 1] - columns.begin[k]);
        sort_by_key(ids, [&](SiteId s) { return coordinates(1 - across, s); });
    }
    return columns;
}

}  // namespace pcvt::plane
