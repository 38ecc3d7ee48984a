#include "mesher/space/grains/cell_refinement.hpp"

#include <algorithm>
#include <cmath>
#include <queue>
#include <tuple>
#include <vector>

#include "mesher/base/checkpoint.hpp"
#include "mesher/space/grains/cavity.hpp"

namespace pcvt::space {
namespace {

/// Distances of first vertices, over the size of the cell, and the least local size there.
constexpr double kLatticeFromVertices = 0.7;
constexpr double kLatticeFromHull = 0.55;
constexpr double kLatticeSize = 0.7;
/// Distances of further vertices over the local size.
constexpr double kFromVertices = 0.65;
constexpr double kFromHull = 0.45;
/// The height above a triangle of the hull over the mean length of its edges.
constexpr double kAboveHull = 0.75;

class Refinement {
   public:
    Refinement(CellTetrahedra& cell, const RefinementChoices& choices)
        : cell_(cell), choices_(choices), cavity_(cell) {}

    void run() {
        for (int t = 0; t < cell_.n_numbers(); ++t) {
            if (cell_.is_alive(t)) queue(t);
        }
        long n = 0;
        while (!queue_.empty()) {
            checkpoint_each(++n);
            const auto [excess, t, corners] = queue_.top();
            queue_.pop();
            if (cell_.is_alive(t) && cell_.corners(t) == corners) refine(t);
        }
    }

   private:
    /// The circumradius over the local size, the tetrahedron, and its corners, since its number may
    /// be used again.
    using Large = std::tuple<double, int, FourCorners>;

    double local_size(int t) const {
        const Vec3 middle = cell_.barycentre(t);
        double size = choices_.size;
        for (const int v : cell_.corners(t)) {
            size = std::min(size, cell_.size(v) + kSizeGrowth * distance(cell_.point(v), middle));
        }
        return size;
    }

    void queue(int t) {
        const double radius = cell_.circumsphere_of(t).radius;
        if (!std::isfinite(radius)) return;
        const double excess = radius / local_size(t);
        if (excess > choices_.radius) queue_.emplace(excess, t, cell_.corners(t));
    }

    void refine(int t) {
        candidates_.assign(1, cell_.circumsphere_of(t).centre);
        for (int k = 0; k < 4; ++k) {
            if (cell_.neighbour(t, k) < 0) candidates_.push_back(above_hull(cell_.triangle(t, k)));
        }
        candidates_.push_back(cell_.barycentre(t));
        for (const Vec3& x : candidates_) {
            if (!insert(x, t)) continue;
            for (const int fresh : cell_.fresh()) queue(fresh);
            return;
        }
    }

    Vec3 above_hull(const ThreeCorners& triangle) const {
        const Vec3& a = cell_.point(triangle[0]);
        const Vec3& b = cell_.point(triangle[1]);
        const Vec3& c = cell_.point(triangle[2]);
        const double edge = (distance(a, b) + distance(b, c) + distance(c, a)) / 3;
        const Vec3 outward = unit_vector(cross_product(b - a, c - a));
        return (a + b + c) / 3 - kAboveHull * edge * outward;
    }

    bool insert(const Vec3& x, int start) {
        const int holder = cell_.locate(x, start);
        if (holder < 0 || !cavity_.find(x, holder)) return false;
        const double size = cavity_.size(choices_.size);
        if (!cavity_.has_room(kFromVertices * size, kFromHull * size)) return false;
        cavity_.fill(size);
        return true;
    }

    CellTetrahedra& cell_;
    const RefinementChoices& choices_;
    Cavity cavity_;
    std::priority_queue<Large> queue_;
    std::vector<Vec3> candidates_;
};

}  // namespace

void insert_lattice(CellTetrahedra& cell, const RefinementChoices& choices, const Vec3& anchor) {
    if (choices.lattice_edge <= 0) return;
    const double edge = choices.lattice_edge * choices.size;
    Vec3 low = cell.point(0);
    Vec3 high = low;
    for (int v = 0; v < cell.n_hull(); ++v) {
        low = low.cwiseMin(cell.point(v));
        high = high.cwiseMax(cell.point(v));
    }
    const Vec3 from = ((low - anchor) / edge).array().floor();
    const Vec3 to = (high - anchor) / edge;
    Cavity cavity(cell);
    int start = cell.any();
    const auto insert = [&](double x, double y, double z) {
        const Vec3 at = anchor + edge * Vec3(x, y, z);
        const int holder = cell.locate(at, start);
        if (holder < 0 || !cavity.find(at, holder)) return;
        const double size = cavity.size(choices.size);
        if (size <= kLatticeSize * choices.size ||
            !cavity.has_room(kLatticeFromVertices * choices.size,
                             kLatticeFromHull * choices.size)) {
            return;
        }
        cavity.fill(size);
        start = cell.fresh().front();
    };
    for (double x = from.x(); x < to.x(); ++x) {
        checkpoint();
        for (double y = from.y(); y < to.y(); ++y) {
            for (double z = from.z(); z < to.z(); ++z) {
                insert(x, y, z);
                insert(x + 0.5, y + 0.5, z + 0.5);
            }
        }
    }
}

void refine(CellTetrahedra& cell, const RefinementChoices& choices) {
    Refinement(cell, choices).run();
}

}  // namespace pcvt::space
