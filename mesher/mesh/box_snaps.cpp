#include "mesher/mesh/box_snaps.hpp"

#include <algorithm>
#include <cmath>

#include "mesher/mesh/box_lines.hpp"

namespace pcvt {
namespace {

/// What an earlier cut did not move is moved within this many snapping distances.
constexpr double kFreshSnap = 1.0 / 3;

/// Returns the distance between neighbouring lines of a family.
double line_spacing(const Lattice& lattice, int axis) {
    return lattice.area() / (axis == 0 ? lattice.b() : lattice.a()).norm();
}

}  // namespace

OnLines BoxSnapper::lines_near(int v, const Vec2& u) const {
    const Vec2 to_corner = u - Vec2(u.array().round());
    const OnLines before = earlier_.vertices.empty() ? OnLines{} : earlier_.vertices[v];
    if (lattice_.to_plane(to_corner).norm() < reach(before[0] && before[1])) return {true, true};
    std::array<double, 2> distance;
    for (const int axis : BoxLines::kAxes) {
        distance[axis] = std::abs(to_corner[axis]) * line_spacing(lattice_, axis);
    }
    // If the lines meet at a small angle, both may be near although the corner is not.
    int nearer = distance[1] < distance[0] ? 1 : 0;
    if (before[0] != before[1]) nearer = before[1] ? 1 : 0;
    OnLines on{};
    on[nearer] = distance[nearer] < reach(before[nearer]);
    return on;
}

bool BoxSnapper::is_bent(const BoxSnaps::Bend& bend, double distance) const {
    const auto& bends = earlier_.bends;
    return distance <= reach(std::find(bends.begin(), bends.end(), bend) != bends.end());
}

SnapReach reach_after(const BoxSnaps& earlier, double snap) {
    const bool is_first = earlier.vertices.empty();
    return {is_first ? snap : kFreshSnap * snap, kHeldSnap * snap};
}

}  // namespace pcvt
