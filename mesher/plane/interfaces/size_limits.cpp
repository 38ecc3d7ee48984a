#include "mesher/plane/interfaces/size_limits.hpp"

#include <algorithm>
#include <limits>

#include "mesher/plane/interfaces/curve_samples.hpp"

namespace pcvt::plane {
namespace {

/// Up to this distance from a limit, in chords, it holds without growth.
constexpr double kPlateau = 2;
constexpr int kLimitsPerLeaf = 8;
/// Distances of boxes and of points are rounded.
constexpr double kBoxRounding = 1 - 1e-12;

double grown(double size, double distance) {
    return size + kGrading * std::max(0.0, distance - kPlateau * size);
}

}  // namespace

double size_at(const std::vector<SizeLimit>& limits, const Vec2& p) {
    double size = std::numeric_limits<double>::infinity();
    for (const SizeLimit& limit : limits) {
        size = std::min(size, grown(limit.size, (p - limit.point).norm()));
    }
    return size;
}

SizeLimits::SizeLimits(const std::vector<SizeLimit>& limits) : limits_(limits) {
    if (!limits_.empty()) add_node(0, static_cast<int>(limits_.size()));
}

int SizeLimits::add_node(int first, int last) {
    const auto n = static_cast<int>(nodes_.size());
    nodes_.push_back(
        {first, last, -1, limits_[first].point, limits_[first].point, limits_[first].size});
    for (int k = first; k < last; ++k) {
        nodes_[n].low = nodes_[n].low.cwiseMin(limits_[k].point);
        nodes_[n].high = nodes_[n].high.cwiseMax(limits_[k].point);
        nodes_[n].least = std::min(nodes_[n].least, limits_[k].size);
    }
    if (last - first <= kLimitsPerLeaf) return n;
    // Divide the longer side of the box in the middle of the points.
    const Vec2 size = nodes_[n].high - nodes_[n].low;
    const int axis = size.x() > size.y() ? 0 : 1;
    const int middle = (first + last) / 2;
    std::nth_element(limits_.begin() + first, limits_.begin() + middle, limits_.begin() + last,
                     [axis](const SizeLimit& one, const SizeLimit& other) {
                         return one.point[axis] < other.point[axis];
                     });
    add_node(first, middle);
    const int second = add_node(middle, last);
    nodes_[n].second = second;
    return n;
}

double SizeLimits::at(const Vec2& p) const {
    double size = std::numeric_limits<double>::infinity();
    if (!nodes_.empty()) search(p, 0, size);
    return size;
}

void SizeLimits::search(const Vec2& p, int n, double& size) const {
    const Node& node = nodes_[n];
    const double distance = (p - p.cwiseMax(node.low).cwiseMin(node.high)).norm();
    if (kBoxRounding * grown(node.least, distance) > size) return;
    if (node.second < 0) {
        for (int k = node.first; k < node.last; ++k) {
            size = std::min(size, grown(limits_[k].size, (p - limits_[k].point).norm()));
        }
        return;
    }
    search(p, n + 1, size);
    search(p, node.second, size);
}

}  // namespace pcvt::plane
