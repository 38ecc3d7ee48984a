#include "mesher/space/grains/cell_tetrahedra.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <utility>

#include "mesher/base/error.hpp"

namespace pcvt::space {
namespace {

constexpr int kMostTetrahedronSteps = 3000;
constexpr FourCorners kNoNeighbours{-1, -1, -1, -1};
/// Twice kFlatTetrahedron of the proof, whose points have other roundings.
constexpr double kFlat = 2e-9;
/// Side::k of a side whose other side was found.
constexpr int kLinked = -2;

/// The mean length of the edges of the hull at each of its points.
std::vector<double> hull_sizes(const CellHull& hull) {
    std::vector<double> sums(hull.points.size(), 0);
    std::vector<int> n_edges(hull.points.size(), 0);
    for (const ThreeCorners& triangle : hull.triangles) {
        for (int k = 0; k < 3; ++k) {
            const int a = triangle[k];
            const int b = triangle[(k + 1) % 3];
            const double edge = distance(hull.points[a], hull.points[b]);
            for (const int v : {a, b}) {
                sums[v] += edge;
                ++n_edges[v];
            }
        }
    }
    for (std::size_t v = 0; v < sums.size(); ++v) sums[v] /= n_edges[v];
    return sums;
}

}  // namespace

CellTetrahedra::CellTetrahedra(const CellHull& hull, const Vec3& centre)
    : n_hull_(static_cast<int>(hull.points.size())),
      near_(hull.near),
      points_(hull.points),
      sizes_(hull_sizes(hull)),
      one_at_(hull.points.size(), -1),
      changes_(hull.points.size(), 1),
      vertex_failures_(hull.points.size()) {
    double size = kUnlimited;
    for (int v = 0; v < n_hull_; ++v) {
        size = std::min(size, sizes_[v] + kSizeGrowth * distance(points_[v], centre));
    }
    const int v = add_vertex(centre, size);
    std::vector<FourCorners> star;
    HullChange all;
    for (const ThreeCorners& t : hull.triangles) {
        star.push_back({v, t[0], t[1], t[2]});
        all.come.push_back(t);
    }
    replace({}, star, all);
}

double CellTetrahedra::worst() const {
    double least = kUnlimited;
    for (int t = 0; t < n_numbers(); ++t) {
        if (is_alive(t)) least = std::min(least, quality_[t]);
    }
    return least;
}

double CellTetrahedra::flatness_of(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    const double longest =
        std::max({squared_distance(a, b), squared_distance(a, c), squared_distance(a, d),
                  squared_distance(b, c), squared_distance(b, d), squared_distance(c, d)});
    return volume6(a, b, c, d) / (6 * longest * std::sqrt(longest));
}

double CellTetrahedra::flatness(int t) const {
    const auto& [a, b, c, d] = corners_[t];
    return flatness_of(points_[a], points_[b], points_[c], points_[d]);
}

bool CellTetrahedra::is_flat(int t) const { return !(flatness(t) > kFlat); }

bool CellTetrahedra::has_corner(int t, int v) const {
    const FourCorners& c = corners_[t];
    return c[0] == v || c[1] == v || c[2] == v || c[3] == v;
}

int CellTetrahedra::index_of(int t, int v) const {
    int k = 0;
    while (corners_[t][k] != v) ++k;
    return k;
}

Circumsphere CellTetrahedra::circumsphere_of(int t) const {
    const FourCorners& c = corners_[t];
    return circumsphere(points_[c[0]], points_[c[1]], points_[c[2]], points_[c[3]]);
}

Vec3 CellTetrahedra::barycentre(int t) const {
    const FourCorners& c = corners_[t];
    return 0.25 * (points_[c[0]] + points_[c[1]] + points_[c[2]] + points_[c[3]]);
}

void CellTetrahedra::find_star(int v, std::vector<int>& star) const {
    star.assign(1, one_at_[v]);
    marks_[star[0]] = 1;
    for (std::size_t i = 0; i < star.size(); ++i) {
        const int t = star[i];
        for (int k = 0; k < 4; ++k) {
            const int o = neighbours_[t][k];
            if (o < 0 || corners_[t][k] == v || marks_[o] != 0) continue;
            marks_[o] = 1;
            star.push_back(o);
        }
    }
    for (const int t : star) marks_[t] = 0;
}

int CellTetrahedra::locate(const Vec3& x, int start) const {
    int t = start;
    for (int step = 0; step < kMostTetrahedronSteps; ++step) {
        // The first triangle to be tried changes with the steps, so that the walk cannot circle.
        int exit = -1;
        for (int i = 0; i < 4 && exit < 0; ++i) {
            const int k = (i + step) % 4;
            const ThreeCorners a = triangle(t, k);
            if (volume6(points_[a[0]], points_[a[1]], points_[a[2]], x) > 0) exit = k;
        }
        if (exit < 0) return t;
        t = neighbours_[t][exit];
        if (t < 0) return -1;
    }
    return -1;
}

int CellTetrahedra::any() const {
    int t = 0;
    while (!is_alive(t)) ++t;
    return t;
}

CellTetrahedra::Side CellTetrahedra::side(const ThreeCorners& triangle, int t, int k) {
    auto [a, b, c] = triangle;
    if (a > b) std::swap(a, b);
    if (b > c) std::swap(b, c);
    if (a > b) std::swap(a, b);
    return {a, b, c, t, k};
}

int CellTetrahedra::add(const FourCorners& corners) {
    int t = n_numbers();
    if (free_.empty()) {
        corners_.push_back(corners);
        neighbours_.push_back(kNoNeighbours);
        quality_.push_back(0);
        alive_.push_back(1);
        marks_.push_back(0);
        failures_.push_back({});
    } else {
        t = free_.back();
        free_.pop_back();
        corners_[t] = corners;
        neighbours_[t] = kNoNeighbours;
        alive_[t] = 1;
        failures_[t] = {};
    }
    quality_[t] = quality_of(corners);
    for (const int v : corners) one_at_[v] = t;
    return t;
}

void CellTetrahedra::collect_boundary(std::span<const int> old, const HullChange& hull) {
    const auto vanishes = [&](const Side& s) {
        return std::any_of(hull.gone.begin(), hull.gone.end(), [&](const ThreeCorners& triangle) {
            const Side g = side(triangle, -1, -1);
            return s.a == g.a && s.b == g.b && s.c == g.c;
        });
    };
    for (const ThreeCorners& triangle : hull.come) link(side(triangle, -1, -1));
    for (const int t : old) marks_[t] = 1;
    for (const int t : old) {
        for (int k = 0; k < 4; ++k) {
            const int o = neighbours_[t][k];
            if (o >= 0 && marks_[o] != 0) continue;
            int back = -1;
            if (o >= 0) {
                back = 0;
                while (neighbours_[o][back] != t) ++back;
            }
            const Side here = side(triangle(t, k), o, back);
            if (o >= 0 || !vanishes(here)) link(here);
        }
    }
    for (const int t : old) marks_[t] = 0;
}

/// Links a side with the other one on the same triangle, or keeps it until that comes.
void CellTetrahedra::link(const Side& s) {
    const std::size_t mask = slots_.size() - 1;
    const auto hash = static_cast<std::uint32_t>(s.a) * 0x9E3779B1u ^
                      static_cast<std::uint32_t>(s.b) * 0x85EBCA77u ^
                      static_cast<std::uint32_t>(s.c) * 0xC2B2AE3Du;
    for (std::size_t k = (hash >> 15 ^ hash) & mask;; k = (k + 1) & mask) {
        Slot& slot = slots_[k];
        if (slot.replacement != n_replacements_) {
            slot = {s, n_replacements_};
            ++n_waiting_;
            return;
        }
        Side& r = slot.side;
        if (s.a != r.a || s.b != r.b || s.c != r.c || r.k == kLinked) continue;
        if (s.tetrahedron >= 0) neighbours_[s.tetrahedron][s.k] = r.tetrahedron;
        if (r.tetrahedron >= 0) neighbours_[r.tetrahedron][r.k] = s.tetrahedron;
        r.k = kLinked;
        --n_waiting_;
        return;
    }
}

void CellTetrahedra::replace(std::span<const int> old, std::span<const FourCorners> fresh,
                             const HullChange& hull) {
    const std::size_t most_sides = 4 * (old.size() + fresh.size()) + hull.come.size();
    if (2 * slots_.size() < 3 * most_sides) slots_.assign(std::bit_ceil(2 * most_sides), {});
    ++n_replacements_;
    ++now_;
    n_waiting_ = 0;
    collect_boundary(old, hull);
    for (const int t : old) {
        alive_[t] = 0;
        note_change(corners_[t]);
    }
    free_.insert(free_.end(), old.begin(), old.end());
    fresh_.clear();
    for (const FourCorners& corners : fresh) {
        const int t = add(corners);
        fresh_.push_back(t);
        note_change(corners);
        for (int k = 0; k < 4; ++k) link(side(triangle(t, k), t, k));
    }
    if (n_waiting_ != 0) {
        throw InternalError("tetrahedra of a cell were replaced by others of another hull");
    }
}

void CellTetrahedra::set_near(const std::vector<char>& near) {
    if (near == near_) return;
    near_ = near;
    ++now_;
    for (int t = 0; t < n_numbers(); ++t) {
        if (!is_alive(t)) continue;
        const double before = std::exchange(quality_[t], quality_of(corners_[t]));
        if (quality_[t] != before) note_change(corners_[t]);
    }
}

void CellTetrahedra::scale(double factor) {
    for (Vec3& p : points_) p *= factor;
    for (double& size : sizes_) size *= factor;
}

void CellTetrahedra::release_memory() {
    // An empty list in braces would leave the memory with the vector.
    slots_.clear();
    slots_.shrink_to_fit();
    points_.shrink_to_fit();
    sizes_.shrink_to_fit();
    one_at_.shrink_to_fit();
    corners_.shrink_to_fit();
    neighbours_.shrink_to_fit();
    quality_.shrink_to_fit();
    alive_.shrink_to_fit();
    marks_.shrink_to_fit();
    free_.shrink_to_fit();
    fresh_.shrink_to_fit();
    changes_.shrink_to_fit();
    vertex_failures_.shrink_to_fit();
    failures_.shrink_to_fit();
}

int CellTetrahedra::add_vertex(const Vec3& at, double size) {
    points_.push_back(at);
    sizes_.push_back(size);
    one_at_.push_back(-1);
    changes_.push_back(now_);
    vertex_failures_.push_back({});
    return n_vertices() - 1;
}

void CellTetrahedra::update_quality(std::span<const int> tetrahedra) {
    ++now_;
    for (const int t : tetrahedra) {
        quality_[t] = quality_of(corners_[t]);
        note_change(corners_[t]);
    }
}

}  // namespace pcvt::space
