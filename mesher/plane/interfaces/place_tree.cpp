#include "mesher/plane/interfaces/place_tree.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

#include "mesher/base/checkpoint.hpp"

namespace pcvt::plane {
namespace {

constexpr int kPlacesPerLeaf = 8;
/// Boxes count as wider by this part of a period, because coordinates are rounded.
constexpr double kWider = 1e-12;

}  // namespace

PlaceTree::PlaceTree(const Lattice& reduced, Points places)
    : reduced_(reduced),
      grid_(reduced, static_cast<int>(places.cols())),
      places_(std::move(places)),
      order_(static_cast<std::size_t>(places_.cols())) {
    std::iota(order_.begin(), order_.end(), 0);
    if (!order_.empty()) add_node(0, static_cast<int>(order_.size()));
}

int PlaceTree::add_node(int first, int last) {
    checkpoint_each(last - first, 64);
    const auto n = static_cast<int>(nodes_.size());
    nodes_.push_back({first, last, -1, places_.col(order_[first]), places_.col(order_[first])});
    for (int k = first; k < last; ++k) {
        nodes_[n].low = nodes_[n].low.cwiseMin(places_.col(order_[k]));
        nodes_[n].high = nodes_[n].high.cwiseMax(places_.col(order_[k]));
    }
    if (last - first <= kPlacesPerLeaf) return n;
    const Vec2 size = nodes_[n].high - nodes_[n].low;
    const int axis = size.x() > size.y() ? 0 : 1;
    const int middle = (first + last) / 2;
    std::nth_element(order_.begin() + first, order_.begin() + middle, order_.begin() + last,
                     [&](int s, int t) { return places_(axis, s) < places_(axis, t); });
    add_node(first, middle);
    const int second = add_node(middle, last);
    nodes_[n].second = second;
    return n;
}

std::vector<PlaceTree::Found> PlaceTree::within(const Vec2& u, double distance) const {
    std::vector<Found> found;
    if (nodes_.empty()) return found;
    // By how much the disc extends in each coordinate.
    const Vec2 reach =
        Vec2(reduced_.b().norm(), reduced_.a().norm()) * (distance / reduced_.area()) +
        Vec2::Constant(kWider);
    const Vec2 first = (u - reach - nodes_[0].high).array().ceil();
    const Vec2 last = (u + reach - nodes_[0].low).array().floor();
    std::vector<int> open;
    for (int i = int(first.x()); i <= int(last.x()); ++i) {
        for (int j = int(first.y()); j <= int(last.y()); ++j) {
            const Vec2 at = u - Vec2(i, j);
            open.assign(1, 0);
            while (!open.empty()) {
                const Node& node = nodes_[open.back()];
                const auto n = open.back();
                open.pop_back();
                const Vec2 gap = (node.low - at).cwiseMax(at - node.high);
                if (gap.x() > reach.x() || gap.y() > reach.y()) continue;
                if (node.second >= 0) {
                    open.insert(open.end(), {n + 1, node.second});
                    continue;
                }
                for (int k = node.first; k < node.last; ++k) {
                    const Vec2 d = places_.col(order_[k]) + Vec2(i, j) - u;
                    if (reduced_.to_position(d).norm() < distance) {
                        found.push_back({order_[k], {i, j}});
                    }
                }
            }
        }
    }
    const auto rank = [&](const Found& f) {
        return std::tuple(grid_.row_and_column(places_.col(f.place), f.offset), -f.place);
    };
    std::sort(found.begin(), found.end(),
              [&](const Found& s, const Found& t) { return rank(s) < rank(t); });
    return found;
}

}  // namespace pcvt::plane
