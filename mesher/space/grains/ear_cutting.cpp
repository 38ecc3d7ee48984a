#include "mesher/space/grains/ear_cutting.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>
#include <utility>

namespace pcvt::space {
namespace {

class EarCutting {
   public:
    explicit EarCutting(std::vector<Point2>& points) : points_(points), rest_(points.size()) {
        std::iota(rest_.begin(), rest_.end(), 0);
    }

    std::vector<std::array<int, 3>> run() {
        while (rest_.size() > 3 && cut_widest()) {
        }
        if (rest_.size() == 3) {
            triangles_.push_back({rest_[0], rest_[1], rest_[2]});
        } else {
            add_star();
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
        const double flat =
            kFlatTriangle * (square(points_[c] - points_[a]) + square(points_[b] - points_[a]) +
                             square(points_[c] - points_[b]));
        if (area2(a, b, c) <= flat) return -1;
        // What is left must not be flat either.
        if (rest_.size() == 4) {
            const int d = at(k + 2);
            return area2(a, c, d) <= flat ? -1 : std::min(width, sine(a, c, d));
        }
        const bool leaves_area =
            std::any_of(rest_.begin(), rest_.end(), [&](int v) { return area2(a, c, v) > flat; });
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

    void add_star() {
        Point2 middle = Point2::Zero();
        for (const int v : rest_) middle += points_[v] / static_cast<double>(rest_.size());
        const int centre = static_cast<int>(points_.size());
        points_.push_back(middle);
        for (int k = 0; k < static_cast<int>(rest_.size()); ++k) {
            triangles_.push_back({centre, at(k), at(k + 1)});
        }
    }

    std::vector<Point2>& points_;
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

std::vector<std::array<int, 3>> cut_ears(std::vector<Point2>& polygon) {
    return EarCutting(polygon).run();
}

}  // namespace pcvt::space
