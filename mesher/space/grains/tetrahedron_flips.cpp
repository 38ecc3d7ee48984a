#include "mesher/space/grains/tetrahedron_flips.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace pcvt::space {
namespace {

/// Rings of more vertices round an inner edge hardly ever gain.
constexpr int kMostInnerRing = 9;

void begin(FlipPlan& plan) {
    plan.old.clear();
    plan.fresh.clear();
    plan.before = kUnlimited;
    plan.after = -kUnlimited;
}

}  // namespace

int TetrahedronFlips::fourth(int t, int a, int b, int c) const {
    for (const int v : cell_.corners(t)) {
        if (v != a && v != b && v != c) return v;
    }
    return -1;
}

double TetrahedronFlips::pair_quality(int a, int b, int i, int k, int j, double least) const {
    const Vec3& p = cell_.point(ring_[i]);
    const Vec3& q = cell_.point(ring_[k]);
    const Vec3& r = cell_.point(ring_[j]);
    const FourCorners below{a, ring_[i], ring_[k], ring_[j]};
    const double of_a = cell_.rated(below, smallest_sine(cell_.point(a), p, q, r));
    if (of_a <= least) return of_a;
    const FourCorners above{b, ring_[i], ring_[j], ring_[k]};
    return std::min(of_a, cell_.rated(above, smallest_sine(cell_.point(b), p, r, q)));
}

bool TetrahedronFlips::triangulate_ring(int a, int b, double least, FlipPlan& plan) {
    const int n = static_cast<int>(ring_.size());
    // best[i][j]: of the tetrahedra over the polygon of the vertices i ... j; split[i][j]: the
    // third vertex of its triangle on the edge (i, j).
    std::array<std::array<double, kMostRingVertices + 1>, kMostRingVertices + 1> best{};
    std::array<std::array<int, kMostRingVertices + 1>, kMostRingVertices + 1> split{};
    for (int i = 0; i + 1 < n; ++i) best[i][i + 1] = kUnlimited;
    for (int width = 2; width < n; ++width) {
        for (int i = 0; i + width < n; ++i) {
            const int j = i + width;
            double here = least;
            split[i][j] = -1;
            for (int k = i + 1; k < j; ++k) {
                double quality = std::min(best[i][k], best[k][j]);
                if (quality <= here) continue;
                quality = std::min(quality, pair_quality(a, b, i, k, j, here));
                if (quality <= here) continue;
                here = quality;
                split[i][j] = k;
            }
            best[i][j] = here;
        }
    }
    if (split[0][n - 1] < 0) return false;
    plan.after = best[0][n - 1];
    std::vector<std::pair<int, int>> runs{{0, n - 1}};
    while (!runs.empty()) {
        const auto [i, j] = runs.back();
        runs.pop_back();
        if (j - i < 2) continue;
        const int k = split[i][j];
        plan.fresh.push_back({a, ring_[i], ring_[k], ring_[j]});
        plan.fresh.push_back({b, ring_[i], ring_[j], ring_[k]});
        runs.insert(runs.end(), {{i, k}, {k, j}});
    }
    return true;
}

bool TetrahedronFlips::close_ring(int start, int a, int b, int first, int second, FlipPlan& plan) {
    ring_.clear();
    int t = start;
    do {
        ring_.push_back(first);
        plan.old.push_back(t);
        plan.before = std::min(plan.before, cell_.quality(t));
        const int next = cell_.neighbour(t, cell_.index_of(t, first));
        if (next < 0 || static_cast<int>(ring_.size()) > kMostInnerRing) return false;
        first = std::exchange(second, fourth(next, a, b, second));
        t = next;
    } while (t != start);
    return static_cast<int>(ring_.size()) >= 3;
}

bool TetrahedronFlips::remove_edge(int t, int i, int j) {
    const FourCorners& corners = cell_.corners(t);
    const int a = corners[i];
    const int b = corners[j];
    int k = 0;
    while (k == i || k == j) ++k;
    int first = corners[k];
    int second = corners[6 - i - j - k];
    // (a, b, first, second) is positively oriented.
    if (volume6(cell_.point(a), cell_.point(b), cell_.point(first), cell_.point(second)) < 0) {
        std::swap(first, second);
    }
    begin(plan_);
    if (!close_ring(t, a, b, first, second, plan_)) return false;
    if (static_cast<int>(ring_.size()) > kMostInnerRing) return false;
    if (!triangulate_ring(a, b, plan_.before + 1e-9, plan_)) return false;
    cell_.replace(plan_.old, plan_.fresh);
    return true;
}

bool TetrahedronFlips::remove_triangle(int t, int k) {
    const int o = cell_.neighbour(t, k);
    if (o < 0) return false;
    const ThreeCorners triangle = cell_.triangle(t, k);
    const int a = cell_.corners(t)[k];
    const int b = fourth(o, triangle[0], triangle[1], triangle[2]);
    const double before = std::min(cell_.quality(t), cell_.quality(o));
    std::array<FourCorners, 3> fresh;
    for (int i = 0; i < 3; ++i) {
        const int p = triangle[i];
        const int q = triangle[(i + 1) % 3];
        fresh[i] = {a, p, q, b};
        if (!(cell_.quality_of(fresh[i]) > before + 1e-9)) return false;
    }
    cell_.replace(std::array{t, o}, fresh);
    return true;
}

bool TetrahedronFlips::flip_at(int t) {
    for (int i = 0; i < 4; ++i) {
        for (int j = i + 1; j < 4; ++j) {
            if (remove_edge(t, i, j)) return true;
        }
    }
    for (int k = 0; k < 4; ++k) {
        if (remove_triangle(t, k)) return true;
    }
    cell_.note_failure(CellTetrahedra::kFlip, t);
    return false;
}

bool TetrahedronFlips::open_ring(int start, int a, int b, int last, FlipPlan& plan) {
    int t = start;
    int from = ring_[0];
    for (;;) {
        plan.old.push_back(t);
        plan.before = std::min(plan.before, cell_.quality(t));
        const int to = fourth(t, a, b, from);
        ring_.push_back(to);
        const int next = cell_.neighbour(t, cell_.index_of(t, from));
        if (next < 0) return to == last && ring_.size() >= 3;
        if (static_cast<int>(ring_.size()) >= kMostRingVertices) return false;
        from = to;
        t = next;
    }
}

bool TetrahedronFlips::find_ring_on_hull(int a, int b, int c, int d, FlipPlan& plan) {
    begin(plan);
    cell_.find_star(a, star_);
    // The tetrahedron behind the triangle (a, b, c) of the hull.
    const auto start = std::find_if(star_.begin(), star_.end(), [&](int t) {
        if (!cell_.has_corner(t, b) || !cell_.has_corner(t, c)) return false;
        return cell_.neighbour(t, cell_.index_of(t, fourth(t, a, b, c))) < 0;
    });
    if (start == star_.end()) return false;
    ring_.assign(1, c);
    if (!open_ring(*start, a, b, d, plan)) return false;
    if (volume6(cell_.point(a), cell_.point(b), cell_.point(ring_[0]), cell_.point(ring_[1])) < 0) {
        std::swap(a, b);
    }
    edge_ = {a, b};
    return true;
}

bool TetrahedronFlips::fill_ring_on_hull(double least, FlipPlan& plan) {
    return triangulate_ring(edge_[0], edge_[1], least, plan);
}

}  // namespace pcvt::space
