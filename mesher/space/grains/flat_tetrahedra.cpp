#include "mesher/space/grains/flat_tetrahedra.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <queue>
#include <tuple>

#include "mesher/base/checkpoint.hpp"
#include "mesher/space/grains/cavity.hpp"
#include "mesher/space/mesh/midside_nodes.hpp"

namespace pcvt::space {
namespace {

/// The flatness below which tetrahedra are divided: a hundred times that which proofs refuse.
constexpr double kDivided = 1e-7;
/// The flatness of new tetrahedra over that of the flattest old one.
constexpr double kLessFlat = 1.5;
/// No more vertices than this for each point of the hull.
constexpr int kMostVertices = 4;

class FlatDivision {
   public:
    explicit FlatDivision(CellTetrahedra& cell) : cell_(cell), cavity_(cell) {}

    void run() {
        for (int t = 0; t < cell_.n_numbers(); ++t) {
            if (cell_.is_alive(t)) queue(t);
        }
        const int most = cell_.n_vertices() + kMostVertices * cell_.n_hull();
        while (!queue_.empty() && cell_.n_vertices() < most) {
            checkpoint();
            const auto [flatness, t, corners] = queue_.top();
            queue_.pop();
            if (cell_.is_alive(t) && cell_.corners(t) == corners) divide(t);
        }
    }

   private:
    /// The flatness, the tetrahedron, and its corners, since its number may be used again.
    using Flat = std::tuple<double, int, FourCorners>;

    void queue(int t) {
        const double flatness = cell_.flatness(t);
        if (flatness < kDivided) queue_.emplace(flatness, t, cell_.corners(t));
    }

    /// Inserts a vertex on the way from the shortest edge of a tetrahedron to its other two
    /// corners, so that the lengths of edges grow with the distance from that edge.
    void divide(int t) {
        const FourCorners c = cell_.corners(t);
        int first = 0;
        double shortest = kUnlimited;
        for (int k = 0; k < static_cast<int>(kEdgeCorners.size()); ++k) {
            const auto& [i, j] = kEdgeCorners[k];
            const double edge = squared_distance(cell_.point(c[i]), cell_.point(c[j]));
            if (edge < shortest) std::tie(shortest, first) = std::pair(edge, k);
        }
        const auto& [i, j] = kEdgeCorners[first];
        const Vec3 from = (cell_.point(c[i]) + cell_.point(c[j])) / 2;
        const Vec3 way = 2 * (cell_.barycentre(t) - from);
        double best = kLessFlat * cell_.flatness(t);
        Vec3 at = from;
        for (double part = 0.5; part * length(way) > std::sqrt(shortest) / 4; part /= 2) {
            const Vec3 x = from + part * way;
            if (!cavity_.find(x, t, Cavity::Sight::kFar)) continue;
            if (const double gained = cavity_.flatness(); gained > best) {
                best = gained;
                at = x;
            }
        }
        if (at == from || !cavity_.find(at, t, Cavity::Sight::kFar)) return;
        cavity_.fill(cavity_.size(kUnlimited));
        for (const int fresh : cell_.fresh()) queue(fresh);
    }

    CellTetrahedra& cell_;
    Cavity cavity_;
    std::priority_queue<Flat, std::vector<Flat>, std::greater<>> queue_;
};

}  // namespace

void divide_flat(CellTetrahedra& cell) { FlatDivision(cell).run(); }

}  // namespace pcvt::space
