#include "mesher/space/grains/ear_cutting.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>
#include <utility>

namespace pcvt::space {
namespace {

/// The least height of a triangle over the extent of its face: 1e4 roundings. The positions of
/// cells have some hundred times as many where a domain has a million cells.
constexpr double kLeastHeight = 2e-12;

class EarCutting {
   public:
    explicit EarCutting(std::vector<Point2>& points)
        : points_(points), extent_(extent_of(points)), rest_(points.size()) {
        std::iota(rest_.begin(), rest_.end(), 0);
    }

    std::vector<std::array<int, 3>> run() {
        while (rest_.size() > 3 && cut_widest()) {
        }
        if (rest_.size() == 3) {
            triangles_.push_back({rest_[0], rest_[1], rest_[2]});
        } else {
            make_star();
        }
        return std::move(triangles_);
    }

   private:
    int at(int k) const {
        const int n = static_cast<int>(rest_.size());
        return rest_[(k + n) % n];
    }
    double area2(int a, int b, int c) const {
        return cross2(points_[b] - points_[a], points_[c] - points_[a]);
    }
    double sine(int a, int b, int c) const {
        return smallest_sine(points_[a], points_[b], points_[c]);
    }

    /// The sine of the smallest angle of the ear at corner k; -1 if it is not above `least` or
    /// there is no ear.
    double ear(int k, double least) const {
        const int a = at(k - 1);
        const int b = at(k);
        const int c = at(k + 1);
        const double width = sine(a, b, c);
        if (width <= least) return -1;
        const double squares = square(points_[c] - points_[a]) + square(points_[b] - points_[a]) +
                               square(points_[c] - points_[b]);
        const auto is_flat = [&](double area2) {
            return is_flat_triangle(area2, squares, extent_);
        };
        if (is_flat(area2(a, b, c))) return -1;
        // What is left must not be flat either.
        if (rest_.size() == 4) {
            const int d = at(k + 2);
            return is_flat(area2(a, c, d)) ? -1 : std::min(width, sine(a, c, d));
        }
        const bool leaves_area = std::any_of(rest_.begin(), rest_.end(),
                                             [&](int v) { return !is_flat(area2(a, c, v)); });
        return leaves_area ? width : -1;
    }

    bool cut_widest() {
        int best = -1;
        double widest = 0;
        for (int k = 0; k < static_cast<int>(rest_.size()); ++k) {
            const double width = ear(k, widest);
            if (width > widest) std::tie(widest, best) = std::pair(width, k);
        }
        if (best < 0) return false;
        triangles_.push_back({at(best - 1), at(best), at(best + 1)});
        rest_.erase(rest_.begin() + best);
        return true;
    }

    /// Joins the whole polygon with its centroid. Where two sides are almost one straight line,
    /// ears may leave the points on that line only, and their middle would lie on it, too.
    void make_star() {
        Point2 sum = Point2::Zero();
        double area = 0;
        const auto n = static_cast<int>(points_.size());
        for (int k = 1; k + 1 < n; ++k) {
            const double part = area2(0, k, k + 1);
            area += part;
            sum += part * (points_[k] + points_[k + 1] - 2 * points_[0]);
        }
        points_.push_back(points_[0] + sum / (3 * area));
        triangles_.clear();
        for (int k = 0; k < n; ++k) triangles_.push_back({n, k, (k + 1) % n});
    }

    std::vector<Point2>& points_;
    double extent_;
    /// The points that are not cut off.
    std::vector<int> rest_;
    std::vector<std::array<int, 3>> triangles_;
};

}  // namespace

double smallest_sine(const Point2& a, const Point2& b, const Point2& c) {
    const double ab = square(b - a);
    const double bc = square(c - b);
    const double ca = square(a - c);
    // The smallest angle lies between the two longer edges.
    const double product = std::max({ab * bc, bc * ca, ca * ab});
    return product > 0 ? cross2(b - a, c - a) / std::sqrt(product) : 0;
}

double extent_of(const std::vector<Point2>& points) {
    double extent = 0;
    for (const Point2& p : points) {
        extent = std::max({extent, std::abs(p.x()), std::abs(p.y())});
    }
    return extent;
}

bool is_flat_triangle(double area2, double squares, double extent) {
    return area2 <= kLeastHeight * extent * std::sqrt(squares);
}

std::vector<std::array<int, 3>> cut_ears(std::vector<Point2>& polygon) {
    return EarCutting(polygon).run();
}

}  // namespace pcvt::space
