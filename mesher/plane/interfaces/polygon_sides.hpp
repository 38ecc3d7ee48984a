#pragma once

#include <limits>

#include "mesher/plane/geometry/polygon.hpp"

namespace pcvt::plane {

/// How the curves of two shapes lie: apart, or one inside of the other; else they touch or cross.
enum class ShapeRelation { kApart, kFirstInside, kSecondInside, kMeet };

double distance_to_segment(const Vec2& p, const Vec2& from, const Vec2& to);

/// The sides of a polygon in a tree of bounding boxes, so that queries take time of order log n.
/// Side k runs from corner k to the next one.
///
/// Example usage:
///
///     const PolygonSides sides(polygon);
///     const bool is_inside = sides.signed_distance(p) < 0;
///
/// Law, tested by number:
///   (1) Each query returns the same as a loop over all sides.
class PolygonSides {
   public:
    PolygonSides() = default;
    explicit PolygonSides(Polygon polygon);

    std::size_t size() const { return polygon_.size(); }
    const Vec2& corner(std::size_t k) const {
        return polygon_[k < polygon_.size() ? k : k - polygon_.size()];
    }

    /// The distance of p from the polygon, negative inside of it.
    double signed_distance(const Vec2& p) const;
    /// Whether two sides that are not neighbours cross, or are nearer to each other than half of
    /// 1e-9 of the length of the first. Takes time of order n log n for curves as they are
    /// measured.
    bool touch_themselves() const;
    /// How this polygon and the other one, translated, lie. Curves touch if they are nearer to each
    /// other than 1e-9 of the size of this one.
    ShapeRelation relation(const PolygonSides& other, const Vec2& translation) const;
    /// The least of `most` and value(k) over all sides k.
    /// @param value  at least the distance of p from side k.
    template <class Value>
    double least(const Vec2& p, double most, const Value& value) const {
        if (!boxes_.empty()) search(p, 0, value, most);
        return most;
    }

   private:
    /// A range of sides, and its bounding box. The children of node k follow it; the second one is
    /// node second.
    struct Node {
        int first;
        int last;
        int second;
        Vec2 low;
        Vec2 high;

        bool is_leaf() const { return second < 0; }
        double distance(const Vec2& p) const { return (p - p.cwiseMax(low).cwiseMin(high)).norm(); }
    };

    /// Distances of boxes and of sides are rounded.
    static constexpr double kRounding = 1 + 1e-12;

    template <class Value>
    void search(const Vec2& p, int n, const Value& value, double& least) const {
        const Node& node = boxes_[n];
        if (node.distance(p) > kRounding * least) return;
        if (node.is_leaf()) {
            for (int k = node.first; k < node.last; ++k) {
                const double found = value(static_cast<std::size_t>(k));
                if (found < least) least = found;
            }
            return;
        }
        const bool second_first = boxes_[node.second].distance(p) < boxes_[n + 1].distance(p);
        search(p, second_first ? node.second : n + 1, value, least);
        search(p, second_first ? n + 1 : node.second, value, least);
    }

    int add_node(int first, int last);
    bool contains(const Vec2& p) const;
    bool crosses_upwards(int n, const Vec2& p) const;
    double distance_to_side(const Vec2& p, std::size_t k) const;
    template <class Visit>
    static bool any_pair(const PolygonSides& one, int n, const PolygonSides& other, int m,
                         const Vec2& translation, const Visit& visit);

    Polygon polygon_;
    std::vector<Node> boxes_;
};

}  // namespace pcvt::plane
