#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "mesher/plane/geometry/lattice.hpp"

namespace pcvt::plane {

/// Items on the torus, sorted into buckets by the reduced coordinates of a point each, to find
/// those near a place with all their images.
///
/// Example usage:
///
///     TorusGrid grid(sites.reduction().reduced, n);
///     for (int k = 0; k < n; ++k) grid.add(k, coordinates.col(k));
///     grid.visit(u, distance, [&](int k, Offset o) { /* image of k, translated by o */ });
class TorusGrid {
   public:
    /// @param reduced   a reduced basis, in which coordinates and offsets are.
    /// @param n_items   the number of items to come, about one for each bucket.
    TorusGrid(const Lattice& reduced, int n_items)
        : across_{reduced.area() / reduced.b().norm(), reduced.area() / reduced.a().norm()} {
        const double side = std::sqrt(reduced.area() / std::max(1, n_items));
        for (int k = 0; k < 2; ++k) {
            count_[k] = static_cast<int>(std::clamp(across_[k] / side, 1.0, 4096.0));
        }
        head_.assign(static_cast<std::size_t>(count_[0]) * count_[1], -1);
    }

    /// Adds an item whose point has the coordinates u, each in [0, 1). The items are numbered from
    /// 0 in the order of these calls.
    void add(int item, const Vec2& u) {
        int& head = head_[bucket(place(u, 0), place(u, 1))];
        next_.push_back(head);
        item_.push_back(item);
        head = static_cast<int>(item_.size()) - 1;
    }

    /// Calls visit(item, offset) for each image that may lie within `distance` of the point with
    /// the coordinates u, and for some others.
    template <class Visit>
    void visit(const Vec2& u, double distance, const Visit& visit) const {
        std::array<int, 2> first{};
        std::array<int, 2> last{};
        for (int k = 0; k < 2; ++k) {
            const double reach = distance / across_[k] + kRounding;
            first[k] = static_cast<int>(std::floor((u[k] - reach) * count_[k]));
            last[k] = static_cast<int>(std::floor((u[k] + reach) * count_[k]));
        }
        for (int j = first[1]; j <= last[1]; ++j) {
            const int wrapped_j = modulo(j, count_[1]);
            for (int i = first[0]; i <= last[0]; ++i) {
                const int wrapped_i = modulo(i, count_[0]);
                const Offset offset{(i - wrapped_i) / count_[0], (j - wrapped_j) / count_[1]};
                for (int k = head_[bucket(wrapped_i, wrapped_j)]; k >= 0; k = next_[k]) {
                    visit(item_[k], offset);
                }
            }
        }
    }

    /// The row and the column of the bucket of an image: visit() goes row by row, and visits the
    /// items of a bucket in reverse.
    std::array<int, 2> row_and_column(const Vec2& u, Offset offset) const {
        return {place(u, 1) + offset.j * count_[1], place(u, 0) + offset.i * count_[0]};
    }

   private:
    static constexpr double kRounding = 1e-12;

    static int modulo(int i, int n) { return ((i % n) + n) % n; }
    int place(const Vec2& u, int k) const {
        return std::clamp(static_cast<int>(u[k] * count_[k]), 0, count_[k] - 1);
    }
    std::size_t bucket(int i, int j) const {
        return static_cast<std::size_t>(j) * count_[0] + static_cast<std::size_t>(i);
    }

    /// The distances between the sides of the domain across u and across v, length units.
    std::array<double, 2> across_;
    std::array<int, 2> count_{};
    /// Linked lists: the last item of each bucket, and the one before each item.
    std::vector<int> head_;
    std::vector<int> next_;
    std::vector<int> item_;
};

}  // namespace pcvt::plane
