#include "mesher/plane/mesh/box_lines.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mesher/base/checkpoint.hpp"
#include "mesher/base/error.hpp"
#include "mesher/plane/geometry/polygon.hpp"

namespace pcvt::plane {
namespace {

/// Returns the chain that follows the one ending at `end`. Ends and beginnings of chains alternate
/// along the line: from the end of one chain the polygon follows the line to the beginning of the
/// next.
template <class Chain>
int chain_after(const BoxNode& end, const std::vector<Chain>& chains, const BoxPolygon& on_line) {
    auto node = std::find(on_line.begin(), on_line.end(), end);
    while (node != on_line.end() && ++node != on_line.end()) {
        for (std::size_t k = 0; k < chains.size(); ++k) {
            if (chains[k].nodes.front() == *node) return static_cast<int>(k);
        }
    }
    throw InternalError("a cell could not be cut along the box");
}

/// Vertices and edges that an earlier cut left in place move within this many snapping distances.
constexpr double kFreshSnap = 1.0 / 3;

/// Returns the distance between neighbouring lines of a family.
double line_spacing(const Lattice& lattice, int axis) {
    return lattice.area() / (axis == 0 ? lattice.b() : lattice.a()).norm();
}

}  // namespace

BoxLines::Range BoxLines::lines_between(const BoxNode& p, const BoxNode& q, int axis) const {
    const bool up = coordinate(p, axis) < coordinate(q, axis);
    const BoxNode& low = up ? p : q;
    const BoxNode& high = up ? q : p;
    const bool ends_on = on_line(high.vertex, axis);
    return {whole(low.offset, axis) + 1, whole(high.offset, axis) - (ends_on ? 1 : 0)};
}

/// Returns -1, 0 or 1 for a node before, on or behind line k of a family.
int BoxLines::side(const BoxNode& node, int axis, int k) const {
    const int here = whole(node.offset, axis);
    if (here != k) return here < k ? -1 : 1;
    return on_line(node.vertex, axis) ? 0 : 1;
}

bool BoxLines::comes_before(const BoxNode& p, const BoxNode& q, const Line& line) const {
    const int axis = 1 - line.axis;
    const bool left_is_behind = (line.axis == 1) == lattice_.right_handed();
    const bool rising = left_is_behind == (line.kept > 0);
    const BoxNode& first = rising ? p : q;
    const BoxNode& second = rising ? q : p;
    const int i = whole(first.offset, axis);
    const int j = whole(second.offset, axis);
    if (i != j) return i < j;
    return vertices_[first.vertex][axis] < vertices_[second.vertex][axis];
}

/// Returns the box corners strictly between two neighbouring nodes on a line, in order from the
/// first node to the second.
BoxPolygon BoxLines::corners_on_line(const BoxNode& from, const BoxNode& to, const Line& line) {
    const int axis = 1 - line.axis;
    const Range lines = lines_between(from, to, axis);
    BoxPolygon corners;
    for (int l = lines.first; l <= lines.last; ++l) {
        corners.push_back({corner_vertex(), along(line.axis, line.k) + along(axis, l)});
    }
    if (coordinate(to, axis) < coordinate(from, axis)) {
        std::reverse(corners.begin(), corners.end());
    }
    return corners;
}

bool BoxLines::turns_left(const BoxNode& p, const BoxNode& q, const BoxNode& r) const {
    const auto point = [&](const BoxNode& node) {
        return lattice_.to_position({coordinate(node, 0), coordinate(node, 1)});
    };
    return cross(point(q) - point(p), point(r) - point(q)) > 0;
}

std::vector<BoxLines::Chain> BoxLines::chains_of(const BoxPolygon& polygon,
                                                 const Line& line) const {
    const int n = static_cast<int>(polygon.size());
    const auto at = [&](int i) { return polygon[(i + n) % n]; };
    const auto beside = [&](int i) { return side(at(i), line.axis, line.k) == line.kept; };
    // A corner that only touches the line does not end a chain.
    const auto kept = [&](int i) {
        return beside(i) || (side(at(i), line.axis, line.k) == 0 && beside(i - 1) &&
                             beside(i + 1) && turns_left(at(i - 1), at(i), at(i + 1)));
    };
    std::vector<Chain> chains;
    for (int i = 0; i < n; ++i) {
        if (!kept(i) || kept(i - 1)) continue;
        Chain chain;
        int j = i - 1;
        do {
            chain.nodes.push_back(at(j));
        } while (kept(++j));
        chain.nodes.push_back(at(j));
        chains.push_back(std::move(chain));
    }
    return chains;
}

/// Returns all nodes of the polygon on the line and the box corners between them, in order.
BoxPolygon BoxLines::nodes_on_line(const BoxPolygon& polygon, const Line& line) {
    BoxPolygon on_line;
    for (const BoxNode& node : polygon) {
        if (side(node, line.axis, line.k) == 0) on_line.push_back(node);
    }
    std::stable_sort(on_line.begin(), on_line.end(),
                     [&](const BoxNode& p, const BoxNode& q) { return comes_before(p, q, line); });
    BoxPolygon all;
    for (const BoxNode& node : on_line) {
        if (!all.empty()) {
            const BoxPolygon corners = corners_on_line(all.back(), node, line);
            all.insert(all.end(), corners.begin(), corners.end());
        }
        all.push_back(node);
    }
    return all;
}

/// Returns the parts of the polygon on the kept side of a line that crosses it.
std::vector<BoxPolygon> BoxLines::kept_parts(const BoxPolygon& polygon, const Line& line) {
    std::vector<Chain> chains = chains_of(polygon, line);
    const BoxPolygon on_line = nodes_on_line(polygon, line);
    std::vector<BoxPolygon> parts;
    for (std::size_t first = 0; first < chains.size(); ++first) {
        if (chains[first].taken) continue;
        BoxPolygon part;
        for (auto k = first; !chains[k].taken;) {
            chains[k].taken = true;
            const BoxPolygon& chain = chains[k].nodes;
            part.insert(part.end(), chain.begin(), chain.end() - 1);
            k = static_cast<std::size_t>(chain_after(chain.back(), chains, on_line));
            const auto from = std::find(on_line.begin(), on_line.end(), chain.back());
            const auto to = std::find(from, on_line.end(), chains[k].nodes.front());
            part.insert(part.end(), from, to);
        }
        parts.push_back(std::move(part));
    }
    return parts;
}

/// Cuts each polygon along every line of a family that crosses it.
std::vector<BoxPolygon> BoxLines::split_along(const std::vector<BoxPolygon>& polygons, int axis) {
    std::vector<BoxPolygon> done;
    for (BoxPolygon polygon : polygons) {
        checkpoint();
        int k = std::numeric_limits<int>::max();
        for (const BoxNode& node : polygon) k = std::min(k, whole(node.offset, axis) + 1);
        std::vector<BoxPolygon> rest{std::move(polygon)};
        for (; !rest.empty(); ++k) {
            std::vector<BoxPolygon> behind;
            for (const BoxPolygon& part : rest) split_by(part, axis, k, done, behind);
            rest = std::move(behind);
        }
    }
    return done;
}
void BoxLines::split_by(const BoxPolygon& polygon, int axis, int k, std::vector<BoxPolygon>& before,
                        std::vector<BoxPolygon>& behind) {
    const auto any_at = [&](int wanted) {
        return std::any_of(polygon.begin(), polygon.end(),
                           [&](const BoxNode& node) { return side(node, axis, k) == wanted; });
    };
    if (!any_at(1) || !any_at(-1)) {
        (any_at(1) ? behind : before).push_back(polygon);
        return;
    }
    for (BoxPolygon& part : kept_parts(polygon, {axis, k, -1})) before.push_back(std::move(part));
    for (BoxPolygon& part : kept_parts(polygon, {axis, k, 1})) behind.push_back(std::move(part));
}

std::vector<BoxPolygon> BoxLines::split(const BoxPolygon& polygon) {
    return split_along(split_along({polygon}, 0), 1);
}

OnLines BoxSnapper::lines_near(int v, const Vec2& u) const {
    const Vec2 to_corner = u - Vec2(u.array().round());
    const OnLines before = earlier_.vertices.empty() ? OnLines{} : earlier_.vertices[v];
    const bool is_still = earlier_.is_still(v);
    const double to_both = reach(before[0] && before[1], is_still);
    if (lattice_.to_position(to_corner).norm() < to_both) return {true, true};
    std::array<double, 2> distance;
    for (const int axis : BoxLines::kAxes) {
        distance[axis] = std::abs(to_corner[axis]) * line_spacing(lattice_, axis);
    }
    // If the lines meet at a small angle, both may be near although the corner is not.
    int nearer = distance[1] < distance[0] ? 1 : 0;
    if (before[0] != before[1]) nearer = before[1] ? 1 : 0;
    OnLines on{};
    on[nearer] = distance[nearer] < reach(before[nearer], is_still);
    return on;
}

bool BoxSnapper::is_bent(const BoxSnaps::Bend& bend, double distance, bool is_still) const {
    const auto& bends = earlier_.bends;
    const bool was_bent = std::find(bends.begin(), bends.end(), bend) != bends.end();
    return distance <= reach(was_bent, is_still);
}

SnapReach reach_after(const BoxSnaps& earlier, double snap, double least) {
    const bool is_first = earlier.vertices.empty();
    return {is_first ? snap : kFreshSnap * snap, kHeldSnap * snap, least};
}

}  // namespace pcvt::plane
