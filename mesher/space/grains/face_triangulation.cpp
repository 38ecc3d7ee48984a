#include "mesher/space/grains/face_triangulation.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>
#include <utility>

#include "mesher/space/grains/tetrahedron_shape.hpp"

namespace pcvt::space {
namespace {

/// In units of the sum of the absolute terms of the determinant.
constexpr double kInCircle = 1e-12;
constexpr int kMostWalkSteps = 10000;
constexpr long kMostFlips = 1000000;
constexpr int kImprovements = 4;
constexpr double kRoot = 0.8660254037844386;
const std::array<Point2, 6> kDirections{Point2(1, 0),  Point2(0.5, kRoot),   Point2(-0.5, kRoot),
                                        Point2(-1, 0), Point2(-0.5, -kRoot), Point2(0.5, -kRoot)};
/// The sine of 42 degrees: wide enough.
constexpr double kWideSine = 0.669;

int next(int k) { return (k + 1) % 3; }
int last(int k) { return (k + 2) % 3; }

/// The centre of the circle through three points, relative to the first.
Point2 circumcentre(const Point2& a, const Point2& b, const Point2& c) {
    const Point2 ab = b - a;
    const Point2 ac = c - a;
    const double area = 2 * cross2(ab, ac);
    return {(ac.y() * square(ab) - ab.y() * square(ac)) / area,
            (ab.x() * square(ac) - ac.x() * square(ab)) / area};
}

}  // namespace

FaceTriangulation::FaceTriangulation(std::vector<Point2> boundary)
    : points_(std::move(boundary)),
      n_boundary_(static_cast<int>(points_.size())),
      extent_(extent_of(points_)) {
    triangles_ = cut_ears(points_);
    link();
    std::vector<int> all(triangles_.size());
    std::iota(all.begin(), all.end(), 0);
    make_delaunay(std::move(all));
}

double FaceTriangulation::area2(int a, int b, int c) const {
    return cross2(points_[b] - points_[a], points_[c] - points_[a]);
}

double FaceTriangulation::sine(int a, int b, int c) const {
    return smallest_sine(points_[a], points_[b], points_[c]);
}

void FaceTriangulation::link() {
    struct Side {
        int low, high, t, k;
    };
    std::vector<Side> sides;
    for (int t = 0; t < static_cast<int>(triangles_.size()); ++t) {
        for (int k = 0; k < 3; ++k) {
            const auto [low, high] = std::minmax(triangles_[t][next(k)], triangles_[t][last(k)]);
            sides.push_back({low, high, t, k});
        }
    }
    std::sort(sides.begin(), sides.end(), [](const Side& s, const Side& r) {
        return std::tie(s.low, s.high, s.t) < std::tie(r.low, r.high, r.t);
    });
    neighbours_.assign(triangles_.size(), {-1, -1, -1});
    for (std::size_t i = 0; i + 1 < sides.size(); ++i) {
        const Side& s = sides[i];
        const Side& r = sides[i + 1];
        if (s.low != r.low || s.high != r.high) continue;
        neighbours_[s.t][s.k] = r.t;
        neighbours_[r.t][r.k] = s.t;
    }
}

int FaceTriangulation::apex_across(int t, int k) const {
    const std::array<int, 3>& other = neighbours_[neighbours_[t][k]];
    return static_cast<int>(std::find(other.begin(), other.end(), t) - other.begin());
}

bool FaceTriangulation::in_circle(int t, int point) const {
    const Point2 a = points_[triangles_[t][0]] - points_[point];
    const Point2 b = points_[triangles_[t][1]] - points_[point];
    const Point2 c = points_[triangles_[t][2]] - points_[point];
    const double determinant =
        square(a) * cross2(b, c) + square(b) * cross2(c, a) + square(c) * cross2(a, b);
    const auto size = [](const Point2& p, const Point2& q) {
        return std::abs(p.x() * q.y()) + std::abs(p.y() * q.x());
    };
    return determinant >
           kInCircle * (square(a) * size(b, c) + square(b) * size(c, a) + square(c) * size(a, b));
}

bool FaceTriangulation::may_flip(int t, int k) const {
    const int other = neighbours_[t][k];
    if (other < 0) return false;
    const int a = triangles_[t][k];
    const int b = triangles_[t][next(k)];
    const int c = triangles_[t][last(k)];
    const int d = triangles_[other][apex_across(t, k)];
    const double squares = square(points_[b] - points_[c]) + square(points_[a] - points_[d]);
    return !is_flat_triangle(area2(a, b, d), squares, extent_) &&
           !is_flat_triangle(area2(a, d, c), squares, extent_);
}

void FaceTriangulation::relink(int t, int from, int to) {
    if (t >= 0) std::replace(neighbours_[t].begin(), neighbours_[t].end(), from, to);
}

void FaceTriangulation::flip(int t, int k) {
    const int o = neighbours_[t][k];
    const int m = apex_across(t, k);
    const int a = triangles_[t][k];
    const int b = triangles_[t][next(k)];
    const int c = triangles_[t][last(k)];
    const int d = triangles_[o][m];
    const int beyond_ab = neighbours_[t][last(k)];
    const int beyond_ca = neighbours_[t][next(k)];
    // The other triangle is (d, c, b).
    const int beyond_bd = neighbours_[o][next(m)];
    const int beyond_dc = neighbours_[o][last(m)];
    triangles_[t] = {a, b, d};
    neighbours_[t] = {beyond_bd, o, beyond_ab};
    triangles_[o] = {a, d, c};
    neighbours_[o] = {beyond_dc, beyond_ca, t};
    relink(beyond_bd, o, t);
    relink(beyond_ca, t, o);
}

void FaceTriangulation::make_delaunay(std::vector<int> stack) {
    for (long n = 0; !stack.empty() && n < kMostFlips; ++n) {
        const int t = stack.back();
        stack.pop_back();
        for (int k = 0; k < 3; ++k) {
            const int o = neighbours_[t][k];
            if (o < 0 || !in_circle(t, triangles_[o][apex_across(t, k)]) || !may_flip(t, k)) {
                continue;
            }
            flip(t, k);
            stack.insert(stack.end(), {t, o});
            changed_.insert(changed_.end(), {t, o});
            break;
        }
    }
}

int FaceTriangulation::locate(const Point2& x, int start) const {
    for (int step = 0; step < kMostWalkSteps; ++step) {
        int k = 0;
        while (k < 3 &&
               cross2(points_[triangles_[start][last(k)]] - points_[triangles_[start][next(k)]],
                      x - points_[triangles_[start][next(k)]]) >= 0) {
            ++k;
        }
        if (k == 3) return start;
        start = neighbours_[start][k];
        if (start < 0) return -1;
    }
    return -1;
}

void FaceTriangulation::insert(const Point2& x, int t) {
    const int v = static_cast<int>(points_.size());
    const int second = static_cast<int>(triangles_.size());
    const int third = second + 1;
    const auto [a, b, c] = triangles_[t];
    const std::array<int, 3> beyond = neighbours_[t];
    points_.push_back(x);
    triangles_[t] = {v, b, c};
    triangles_.insert(triangles_.end(), {{v, c, a}, {v, a, b}});
    neighbours_[t] = {beyond[0], second, third};
    neighbours_.insert(neighbours_.end(), {{beyond[1], third, t}, {beyond[2], t, second}});
    relink(beyond[1], t, second);
    relink(beyond[2], t, third);
    changed_ = {t, second, third};
    make_delaunay(changed_);
}

double FaceTriangulation::excess(int t, const FaceLimits& limits) const {
    const auto& [a, b, c] = triangles_[t];
    const double radius = std::sqrt(square(circumcentre(points_[a], points_[b], points_[c])));
    return radius > limits.radius || sine(a, b, c) < limits.sine ? radius : 0;
}

/// The segment whose circle reaches farthest beyond x, or -1.
int FaceTriangulation::encroached_segment(const Point2& x) const {
    int segment = -1;
    double deepest = 0;
    for (int k = 0; k < n_boundary_; ++k) {
        const double depth = dot2(points_[k] - x, points_[(k + 1) % n_boundary_] - x);
        if (depth < deepest) std::tie(deepest, segment) = std::pair(depth, k);
    }
    return segment;
}

/// The last segment beyond which x lies, or -1.
int FaceTriangulation::segment_before(const Point2& x) const {
    for (int k = n_boundary_ - 1; k >= 0; --k) {
        const Point2& a = points_[k];
        if (cross2(points_[(k + 1) % n_boundary_] - a, x - a) <= 0) return k;
    }
    return -1;
}

std::vector<int> FaceTriangulation::refine(const FaceLimits& limits) {
    std::vector<int> obstacles;
    std::vector<double> radius;
    const auto update = [&](int t) { radius[t] = excess(t, limits); };
    for (int t = 0; t < static_cast<int>(triangles_.size()); ++t) {
        radius.push_back(0);
        update(t);
    }
    while (static_cast<int>(points_.size()) < limits.most_points) {
        const auto largest = std::max_element(radius.begin(), radius.end());
        if (!(*largest > 0)) break;
        const int t = static_cast<int>(largest - radius.begin());
        const auto& [a, b, c] = triangles_[t];
        const Point2 centre = points_[a] + circumcentre(points_[a], points_[b], points_[c]);
        int segment = encroached_segment(centre);
        const int place = segment < 0 ? locate(centre, t) : -1;
        if (place < 0) {
            // Neither this centre nor the boundary changes, so it is not tried again.
            *largest = 0;
            if (segment < 0) segment = segment_before(centre);
            if (segment >= 0) obstacles.push_back(segment);
            continue;
        }
        *largest = 0;
        insert(centre, place);
        radius.resize(triangles_.size(), 0);
        for (const int s : changed_) update(s);
    }
    std::sort(obstacles.begin(), obstacles.end());
    obstacles.erase(std::unique(obstacles.begin(), obstacles.end()), obstacles.end());
    return obstacles;
}

void FaceTriangulation::improve() {
    for (int k = 0; k < kImprovements; ++k) {
        move_points();
        flip_thin();
    }
}

void FaceTriangulation::move_points() {
    std::vector<std::vector<int>> stars(points_.size());
    for (int t = 0; t < static_cast<int>(triangles_.size()); ++t) {
        for (const int v : triangles_[t]) stars[v].push_back(t);
    }
    for (int v = n_boundary_; v < static_cast<int>(points_.size()); ++v) {
        const auto width = [&] {
            double least = kUnlimited;
            for (const int t : stars[v]) {
                least = std::min(least, sine(triangles_[t][0], triangles_[t][1], triangles_[t][2]));
            }
            return least;
        };
        double best = width();
        if (best > kWideSine) continue;
        const auto probe = [&](const Point2& x) {
            const Point2 before = std::exchange(points_[v], x);
            const double here = width();
            if (here > best) {
                best = here;
            } else {
                points_[v] = before;
            }
        };
        Point2 sum = Point2::Zero();
        double nearest = kUnlimited;
        for (const int t : stars[v]) {
            for (const int w : triangles_[t]) {
                if (w == v) continue;
                sum += points_[w];
                nearest = std::min(nearest, square(points_[w] - points_[v]));
            }
        }
        nearest = std::sqrt(nearest);
        probe(sum / static_cast<double>(2 * stars[v].size()));
        for (double step = 0.3; step > 0.02; step *= 0.5) {
            for (const Point2& direction : kDirections)
                probe(points_[v] + step * nearest * direction);
        }
    }
}

void FaceTriangulation::flip_thin() {
    for (int t = 0; t < static_cast<int>(triangles_.size()); ++t) {
        for (int k = 0; k < 3; ++k) {
            if (!may_flip(t, k)) continue;
            const int a = triangles_[t][k];
            const int b = triangles_[t][next(k)];
            const int c = triangles_[t][last(k)];
            const int d = triangles_[neighbours_[t][k]][apex_across(t, k)];
            const double before = std::min(sine(a, b, c), sine(b, d, c));
            if (std::min(sine(a, b, d), sine(a, d, c)) > before + 1e-9) flip(t, k);
        }
    }
}

}  // namespace pcvt::space
