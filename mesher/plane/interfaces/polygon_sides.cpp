#include "mesher/plane/interfaces/polygon_sides.hpp"

#include <algorithm>
#include <cmath>

#include "mesher/base/checkpoint.hpp"

namespace pcvt::plane {
namespace {

/// Curves nearer to each other than this, in units of the size of one of them, touch.
constexpr double kSidesTouch = 1e-9;
constexpr int kSidesPerLeaf = 4;

bool segments_cross(const Vec2& p, const Vec2& q, const Vec2& r, const Vec2& s) {
    const auto side = [](const Vec2& from, const Vec2& to, const Vec2& at) {
        return cross(to - from, at - from) > 0;
    };
    return side(p, q, r) != side(p, q, s) && side(r, s, p) != side(r, s, q);
}

/// Whether the segments p q and r s cross, or lie within half of 1e-9 of the length of p q.
bool segments_touch(const Vec2& p, const Vec2& q, const Vec2& r, const Vec2& s) {
    const double near = kSidesTouch * (q - p).norm() / 2;
    const double distance = std::min({distance_to_segment(p, r, s), distance_to_segment(q, r, s),
                                      distance_to_segment(r, p, q), distance_to_segment(s, p, q)});
    return distance <= near || segments_cross(p, q, r, s) || segments_cross(q, p, s, r);
}

}  // namespace

double distance_to_segment(const Vec2& p, const Vec2& from, const Vec2& to) {
    const Vec2 side = to - from;
    const double t = std::clamp(side.dot(p - from) / side.squaredNorm(), 0.0, 1.0);
    return (from + t * side - p).norm();
}

PolygonSides::PolygonSides(Polygon polygon) : polygon_(std::move(polygon)) {
    if (!polygon_.empty()) add_node(0, static_cast<int>(polygon_.size()));
}

int PolygonSides::add_node(int first, int last) {
    const auto n = static_cast<int>(boxes_.size());
    boxes_.push_back({first, last, -1, corner(std::size_t(first)), corner(std::size_t(first))});
    if (last - first <= kSidesPerLeaf) {
        Node& node = boxes_[n];
        for (int k = first; k <= last; ++k) {
            node.low = node.low.cwiseMin(corner(std::size_t(k)));
            node.high = node.high.cwiseMax(corner(std::size_t(k)));
        }
        return n;
    }
    const int middle = (first + last) / 2;
    add_node(first, middle);
    const int second = add_node(middle, last);
    Node& node = boxes_[n];
    node.second = second;
    node.low = boxes_[n + 1].low.cwiseMin(boxes_[second].low);
    node.high = boxes_[n + 1].high.cwiseMax(boxes_[second].high);
    return n;
}

double PolygonSides::distance_to_side(const Vec2& p, std::size_t k) const {
    return distance_to_segment(p, corner(k), corner(k + 1));
}

double PolygonSides::signed_distance(const Vec2& p) const {
    const double distance = least(p, std::numeric_limits<double>::infinity(),
                                  [&](std::size_t k) { return distance_to_side(p, k); });
    return contains(p) ? -distance : distance;
}

bool PolygonSides::contains(const Vec2& p) const {
    return !boxes_.empty() && crosses_upwards(0, p);
}

/// Whether the sides of a node cross the ray from p to the right an odd number of times.
bool PolygonSides::crosses_upwards(int n, const Vec2& p) const {
    const Node& node = boxes_[n];
    const auto is_above = [&](int k) { return corner(std::size_t(k)).y() > p.y(); };
    if (node.high.x() < p.x() || node.high.y() <= p.y() || node.low.y() > p.y()) return false;
    // All crossings lie to the right.
    if (node.low.x() > p.x()) return is_above(node.first) != is_above(node.last);
    if (!node.is_leaf()) return crosses_upwards(n + 1, p) != crosses_upwards(node.second, p);
    bool odd = false;
    for (int k = node.first; k < node.last; ++k) {
        if (is_above(k) == is_above(k + 1)) continue;
        const Vec2& from = corner(std::size_t(k));
        const Vec2& to = corner(std::size_t(k) + 1);
        const bool is_left = cross(to - from, p - from) > 0;
        if (is_left == (to.y() > from.y())) odd = !odd;
    }
    return odd;
}

/// Visits pairs of sides whose boxes, the second one translated, are near, until visit(i, j) is
/// true; returns whether it was. For a polygon and itself it visits each pair once, i < j.
template <class Visit>
bool PolygonSides::any_pair(const PolygonSides& one, int n, const PolygonSides& other, int m,
                            const Vec2& translation, const Visit& visit) {
    const Node& node = one.boxes_[n];
    const Node& second = other.boxes_[m];
    const Vec2 size = node.high - node.low;
    const double near = kSidesTouch * size.norm();
    const Vec2 gap =
        (node.low - second.high - translation).cwiseMax(second.low + translation - node.high);
    if (gap.maxCoeff() > near) return false;
    checkpoint_each(n + m, 64);
    const bool is_same = &one == &other && n == m;
    if (node.is_leaf() && second.is_leaf()) {
        for (int i = node.first; i < node.last; ++i) {
            for (int j = is_same ? i + 1 : second.first; j < second.last; ++j) {
                if (visit(std::size_t(i), std::size_t(j))) return true;
            }
        }
        return false;
    }
    const auto go = [&](int k, int l) { return any_pair(one, k, other, l, translation, visit); };
    if (is_same) return go(n + 1, m + 1) || go(n + 1, node.second) || go(node.second, node.second);
    const bool splits_first =
        !node.is_leaf() &&
        (second.is_leaf() || node.last - node.first > second.last - second.first);
    if (splits_first) return go(n + 1, m) || go(node.second, m);
    return go(n, m + 1) || go(n, second.second);
}

bool PolygonSides::touch_themselves() const {
    if (boxes_.empty()) return false;
    return any_pair(*this, 0, *this, 0, Vec2(0, 0), [&](std::size_t i, std::size_t j) {
        const bool adjacent = j == i + 1 || (i == 0 && j + 1 == size());
        return !adjacent && segments_touch(corner(i), corner(i + 1), corner(j), corner(j + 1));
    });
}

ShapeRelation PolygonSides::relation(const PolygonSides& other, const Vec2& translation) const {
    if (boxes_.empty() || other.boxes_.empty()) return ShapeRelation::kApart;
    const double near = kSidesTouch * (boxes_[0].high - boxes_[0].low).norm() / 2;
    long n_visited = 0;
    // The distance of each corner of one polygon from the other, with one sign if they are apart.
    int n_inside = 0;
    const auto touches = [&](const PolygonSides& polygon, const Vec2& p) {
        checkpoint_each(++n_visited);
        const double distance = polygon.signed_distance(p);
        if (distance < 0) ++n_inside;
        return std::abs(distance) <= near;
    };
    for (const Vec2& p : polygon_) {
        if (touches(other, p - translation)) return ShapeRelation::kMeet;
    }
    const bool is_first_inside = n_inside == static_cast<int>(size());
    if (n_inside > 0 && !is_first_inside) return ShapeRelation::kMeet;
    n_inside = 0;
    for (const Vec2& p : other.polygon_) {
        if (touches(*this, p + translation)) return ShapeRelation::kMeet;
    }
    const bool is_second_inside = n_inside == static_cast<int>(other.size());
    if (n_inside > 0 && !is_second_inside) return ShapeRelation::kMeet;
    const bool cross = any_pair(*this, 0, other, 0, translation, [&](std::size_t i, std::size_t j) {
        return segments_cross(corner(i), corner(i + 1), other.corner(j) + translation,
                              other.corner(j + 1) + translation);
    });
    if (cross) return ShapeRelation::kMeet;
    return is_first_inside    ? ShapeRelation::kFirstInside
           : is_second_inside ? ShapeRelation::kSecondInside
                              : ShapeRelation::kApart;
}

}  // namespace pcvt::plane
