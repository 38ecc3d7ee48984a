#include "mesher/plane/grains/grain_refinement.hpp"

#include <algorithm>
#include <cmath>
#include <queue>
#include <tuple>
#include <utility>

#include "mesher/base/checkpoint.hpp"
#include "mesher/plane/geometry/polygon.hpp"
#include "mesher/plane/grains/triangle_shape.hpp"
#include "mesher/portable/portable_angles.hpp"

namespace pcvt::plane {
namespace {

using Edge = GrainTriangulation::Edge;

/// A triangle is too large if its circumradius exceeds this many target sizes; the average edge
/// length is then about one size.
constexpr double kLargestRadius = 0.8;
/// Cell edges at least this many sizes long are cut into round(length / size) parts.
constexpr double kLongEdge = 1.5;
/// Heights above an edge, relative to its length. No vertex is inserted lower than kNeedle above a
/// firm edge or a cell edge, and a vertex lower than kOnEdge above a free edge is put onto the
/// edge.
constexpr double kNeedle = 0.1;
constexpr double kOnEdge = 1e-6;
/// The limits on the number of vertices: per vertex of the cells, and per square of the target
/// size. Only a cell that is thousands of times longer than wide exceeds them.
constexpr double kMostAVertex = 1000;
constexpr double kMostASquare = 20;
/// The number of vertices that a refinement usually adds, per square of the target size, from which
/// its progress is estimated.
constexpr double kUsualASquare = 1.2;
constexpr int kStepsBetweenReports = 4096;
/// The largest number of triangles that a walk or a search visits before it stops.
constexpr int kLongestWalk = 10000;

class Refiner {
   public:
    Refiner(GrainTriangulation& grains, const RefinementSizes& sizes,
            const std::function<void(double)>& progress)
        : grains_(grains),
          sizes_(sizes),
          progress_(progress),
          n_before_(grains.n_vertices()),
          n_expected_(kUsualASquare * squares()),
          wanted_sine_(cos_sin_of_degrees(kWantedAngle).sin),
          off_centre_(0.5 / portable_tan(kWantedAngle * M_PI / 360)),
          most_vertices_(kMostAVertex * grains.n_vertices() + kMostASquare * squares()) {}

    RefinementLeft run() {
        split_long_edges();
        for (int t = 0; t < grains_.n_triangles(); ++t) inspect(t);
        for (int step = 1;; ++step) {
            checkpoint_each(step);
            if (progress_ && step % kStepsBetweenReports == 0) progress_(share());
            if (grains_.n_vertices() > most_vertices_) {
                left_.too_thin = finest_cell();
                return std::move(left_);
            }
            if (!encroached_.empty()) {
                split_encroached();
            } else if (!bad_.empty()) {
                mend_worst();
            } else {
                return std::move(left_);
            }
        }
    }

   private:
    /// Returns the area of the triangles, each in units of the squared target size of its cell.
    double squares() const {
        double sum = 0;
        for (int t = 0; t < grains_.n_triangles(); ++t) {
            checkpoint_each(t);
            const auto [p, q, r] = grains_.triangle(t);
            sum += cross(q - p, r - p) / 2 / (size(t) * size(t));
        }
        return sum;
    }

    /// Returns the face with the most triangles.
    int finest_cell() const {
        std::vector<int> n_triangles(sizes_.of_cell.size(), 0);
        for (int t = 0; t < grains_.n_triangles(); ++t) ++n_triangles[grains_.cell(t)];
        const auto most = std::max_element(n_triangles.begin(), n_triangles.end());
        return static_cast<int>(most - n_triangles.begin());
    }

    double share() const { return std::min(1.0, (grains_.n_vertices() - n_before_) / n_expected_); }

    double size(int t) const { return sizes_.of_cell[grains_.cell(t)]; }
    double length(int h) const {
        return (grains_.point(GrainTriangulation::next(h)) - grains_.point(h)).norm();
    }

    void split_long_edges() {
        std::vector<int> suspects;
        for (int h = 0; h < grains_.n_halfedges(); ++h) suspects.push_back(h);
        while (!suspects.empty()) {
            checkpoint();
            const int h = suspects.back();
            suspects.pop_back();
            if (grains_.edge(h) != Edge::kCell || length(h) < kLongEdge * sizes_.of_edges) continue;
            const double parts = std::round(length(h) / sizes_.of_edges);
            grains_.split_edge(h, std::floor(parts / 2) / parts);
            for (const int t : grains_.touched()) {
                suspects.insert(suspects.end(), {3 * t, 3 * t + 1, 3 * t + 2});
            }
        }
    }

    /// Whether the edge subtends more than 90 degrees at p.
    bool encroaches(const Vec2& p, int h) const {
        const Vec2 from = grains_.point(h) - p;
        const Vec2 to = grains_.point(GrainTriangulation::next(h)) - p;
        return from.dot(to) < 0;
    }
    bool is_encroached(int h) const {
        return grains_.edge(h) == Edge::kCell &&
               encroaches(grains_.point(GrainTriangulation::previous(h)), h);
    }

    bool is_too_large(int t, const Vec2& centre) const {
        return (centre - grains_.point(3 * t)).norm() > kLargestRadius * size(t);
    }
    bool is_too_thin(int t) const { return smallest_sine(grains_.triangle(t)) < wanted_sine_; }

    /// Queues triangle t and its encroached edges for improvement.
    void inspect(int t) {
        stamps_.resize(static_cast<std::size_t>(grains_.n_triangles()), 0);
        ++stamps_[t];
        for (int h = 3 * t; h < 3 * t + 3; ++h) {
            if (is_encroached(h)) encroached_.push_back(h);
        }
        if (grains_.is_guard(t)) return;
        const Vec2 centre = circumcentre(grains_.triangle(t));
        if (is_too_large(t, centre) || is_too_thin(t)) {
            bad_.push({(centre - grains_.point(3 * t)).norm(), -t, stamps_[t]});
        }
    }
    void inspect_touched() {
        const std::vector<int> touched = grains_.touched();
        for (const int t : touched) inspect(t);
    }

    void split(int h) {
        grains_.split_edge(h, 0.5);
        inspect_touched();
    }
    void split_encroached() {
        const int h = encroached_.back();
        encroached_.pop_back();
        if (is_encroached(h)) split(h);
    }

    void mend_worst() {
        const auto [radius, minus_t, stamp] = bad_.top();
        bad_.pop();
        const int t = -minus_t;
        if (stamp != stamps_[t]) return;
        if (!mend(t, radius)) ++left_.n_given_up;
    }

    /// Returns the position at which a new vertex would improve the triangle.
    Vec2 new_vertex(int t) const {
        const std::array<Vec2, 3> triangle = grains_.triangle(t);
        Vec2 centre = circumcentre(triangle);
        if (is_too_large(t, centre)) return centre;
        const auto sides = side_lengths(triangle);
        const auto k = std::min_element(sides.begin(), sides.end()) - sides.begin();
        const Vec2 middle = (triangle[static_cast<std::size_t>(k)] +
                             triangle[static_cast<std::size_t>((k + 1) % 3)]) /
                            2;
        const Vec2 way = centre - middle;
        const double enough = off_centre_ * sides[static_cast<std::size_t>(k)];
        return way.norm() > enough ? Vec2(middle + enough / way.norm() * way) : centre;
    }

    struct Place {
        int triangle;
        /// The cell edge or firm edge that blocks the walk; -1: none.
        int barrier;
    };

    /// Walks in a straight line from the centroid of triangle t to p.
    Place locate(int t, const Vec2& p) const {
        const std::array<Vec2, 3> first = grains_.triangle(t);
        const Vec2 start = (first[0] + first[1] + first[2]) / 3;
        const Vec2 way = p - start;
        int from = -1;
        for (int step = 0; step < kLongestWalk; ++step) {
            int exit = -1;
            for (int h = 3 * t; h < 3 * t + 3; ++h) {
                if (h == from) continue;
                const Vec2& a = grains_.point(h);
                const Vec2& b = grains_.point(GrainTriangulation::next(h));
                if (cross(b - a, p - a) >= 0) continue;
                if (cross(way, a - start) <= 0 && cross(way, b - start) >= 0) exit = h;
            }
            if (exit < 0) return {t, -1};
            if (grains_.edge(exit) != Edge::kFree) return {t, exit};
            from = grains_.opposite(exit);
            t = from / 3;
        }
        return {t, -1};
    }

    /// Whether p lies in the circumcircle of the triangle across the free edge h.
    bool in_circle_across(int h, const Vec2& p) const {
        const Vec2& d = grains_.point(GrainTriangulation::previous(grains_.opposite(h)));
        const Vec2 pa = grains_.point(h) - p;
        const Vec2 pb = grains_.point(GrainTriangulation::next(h)) - p;
        const Vec2 da = grains_.point(h) - d;
        const Vec2 db = grains_.point(GrainTriangulation::next(h)) - d;
        return cross(pa, pb) * da.dot(db) + pa.dot(pb) * cross(db, da) < 0;
    }

    /// Returns the cell edges that p would encroach upon if it were inserted into triangle t.
    std::vector<int> encroached_by(int t, const Vec2& p) const {
        std::vector<int> found;
        std::vector<int> stack{3 * t, 3 * t + 1, 3 * t + 2};
        for (int step = 0; !stack.empty() && step < kLongestWalk; ++step) {
            const int h = stack.back();
            stack.pop_back();
            if (grains_.edge(h) == Edge::kCell && encroaches(p, h)) found.push_back(h);
            if (grains_.edge(h) != Edge::kFree || !in_circle_across(h, p)) continue;
            const int o = grains_.opposite(h);
            stack.push_back(GrainTriangulation::next(o));
            stack.push_back(GrainTriangulation::previous(o));
        }
        return found;
    }

    /// Returns the height of p above an edge of its triangle, relative to the length of the edge.
    double height_over(int h, const Vec2& p) const {
        const Vec2 along = grains_.point(GrainTriangulation::next(h)) - grains_.point(h);
        return cross(along, p - grains_.point(h)) / along.squaredNorm();
    }

    /// Records the firm edge h that prevents the improvement of triangle t.
    void blame(int h, int t) {
        if (smallest_sine(grains_.triangle(t)) > smallest_sine_) return;
        for (const int end : {h, GrainTriangulation::next(h)}) {
            left_.in_the_way.push_back(grains_.vertex(end));
        }
    }

    /// Inserts a vertex at p, in triangle t or on one of its free edges, to improve triangle `bad`.
    /// @returns false if p lies so near to a firm edge or a cell edge that a needle would result.
    bool insert(int t, const Vec2& p, int bad) {
        int lowest = 3 * t;
        for (int h = 3 * t; h < 3 * t + 3; ++h) {
            const double height = height_over(h, p);
            if (grains_.edge(h) != Edge::kFree && height < kNeedle) {
                if (grains_.edge(h) == Edge::kFirm) blame(h, bad);
                return false;
            }
            if (height < height_over(lowest, p)) lowest = h;
        }
        if (height_over(lowest, p) > kOnEdge) {
            grains_.insert(t, p);
        } else {
            const Vec2 along =
                grains_.point(GrainTriangulation::next(lowest)) - grains_.point(lowest);
            const double part = along.dot(p - grains_.point(lowest)) / along.squaredNorm();
            if (!(part > 0 && part < 1)) return false;
            grains_.split_edge(lowest, part);
        }
        inspect_touched();
        return true;
    }

    /// Improves triangle t.
    /// @returns false if that is impossible.
    bool mend(int t, double radius) {
        const Vec2 p = new_vertex(t);
        const Place place = locate(t, p);
        if (place.barrier >= 0) {
            if (grains_.edge(place.barrier) != Edge::kCell) {
                blame(place.barrier, t);
                return false;
            }
            split(place.barrier);
            again(t, radius);
            return true;
        }
        const std::vector<int> in_the_way = encroached_by(place.triangle, p);
        if (!in_the_way.empty()) {
            // Splitting one edge may renumber the others; a later attempt finds the ones that still
            // block.
            split(in_the_way.front());
            again(t, radius);
            return true;
        }
        return insert(place.triangle, p, t);
    }
    /// Queues triangle t again if the split did not change it.
    void again(int t, double radius) {
        const std::vector<int>& touched = grains_.touched();
        if (std::find(touched.begin(), touched.end(), t) == touched.end()) {
            bad_.push({radius, -t, stamps_[t]});
        }
    }

    /// The circumradius of a triangle, its negated index, and its stamp when it was queued.
    using Bad = std::tuple<double, int, int>;

    GrainTriangulation& grains_;
    const RefinementSizes& sizes_;
    const std::function<void(double)>& progress_;
    double n_before_;
    double n_expected_;
    double wanted_sine_;
    double smallest_sine_ = cos_sin_of_degrees(kSmallestAngle).sin;
    /// The distance of the off-centre from the shortest edge, relative to the length of that edge.
    double off_centre_;
    double most_vertices_;
    std::vector<int> encroached_;
    std::priority_queue<Bad> bad_;
    std::vector<int> stamps_;
    RefinementLeft left_;
};

}  // namespace

RefinementLeft refine(GrainTriangulation& grains, const RefinementSizes& sizes,
                      const std::function<void(double)>& progress) {
    return Refiner(grains, sizes, progress).run();
}

}  // namespace pcvt::plane
