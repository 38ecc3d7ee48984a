#include "mesher/plane/grains/grain_smoothing.hpp"

#include <algorithm>
#include <cmath>

#include "mesher/base/checkpoint.hpp"
#include "mesher/plane/grains/triangle_shape.hpp"
#include "mesher/portable/portable_angles.hpp"

namespace pcvt::plane {
namespace {

using Edge = GrainTriangulation::Edge;

/// The largest number of rounds over all thin triangles.
constexpr int kRounds = 12;
/// A move is tried in this many directions. Its length starts at kFirstStep of the shortest edge at
/// the vertex and is halved down to kLastStep.
constexpr int kDirections = 8;
constexpr double kFirstStep = 0.4;
constexpr double kLastStep = 0.02;
/// A move must raise the smallest sine by this factor.
constexpr double kBetter = 1.01;

class Smoother {
   public:
    Smoother(GrainTriangulation& grains, double wanted)
        : grains_(grains), wanted_sine_(cos_sin_of_degrees(wanted).sin) {}

    void run() {
        for (int round = 0; round < kRounds; ++round) {
            bool moved = false;
            for (int t = 0; t < grains_.n_triangles(); ++t) {
                checkpoint_each(t);
                if (smallest_sine(grains_.triangle(t)) >= wanted_sine_) continue;
                for (int h = 3 * t; h < 3 * t + 3; ++h) moved = improve(h) || moved;
            }
            if (!moved) return;
        }
    }

   private:
    /// Returns the halfedges that leave the vertex of h; empty if the vertex does not lie inside a
    /// cell.
    std::vector<int> star_of(int h) const {
        std::vector<int> star;
        int turning = h;
        do {
            if (grains_.edge(turning) != Edge::kFree) return {};
            star.push_back(turning);
            turning = GrainTriangulation::next(grains_.opposite(turning));
        } while (turning != h);
        return star;
    }

    double worst_round(const std::vector<int>& star, const Vec2& p) const {
        double worst = 1;
        for (const int h : star) {
            worst =
                std::min(worst, smallest_sine({p, grains_.point(GrainTriangulation::next(h)),
                                               grains_.point(GrainTriangulation::previous(h))}));
        }
        return worst;
    }

    bool improve(int h) {
        const std::vector<int> star = star_of(h);
        if (star.empty()) return false;
        // Find the shortest edge at the vertex.
        const Vec2 from = grains_.point(h);
        double shortest = INFINITY;
        for (const int g : star) {
            shortest =
                std::min(shortest, (grains_.point(GrainTriangulation::next(g)) - from).norm());
        }
        // Search for the position with the widest smallest angle.
        Vec2 best = from;
        const double before = worst_round(star, from);
        double worst = before;
        for (double step = kFirstStep; step > kLastStep; step /= 2) {
            const Vec2 centre = best;
            for (int k = 0; k < kDirections; ++k) {
                const auto [cos, sin] = cos_sin_of_degrees(360.0 * k / kDirections);
                const Vec2 p = centre + step * shortest * Vec2(cos, sin);
                const double here = worst_round(star, p);
                if (here <= worst) continue;
                worst = here;
                best = p;
            }
        }
        // Accept a clear improvement only.
        if (!(worst > kBetter * before)) return false;
        grains_.move(star, best);
        return true;
    }

    GrainTriangulation& grains_;
    double wanted_sine_;
};

}  // namespace

void widen_angles(GrainTriangulation& grains, double wanted) { Smoother(grains, wanted).run(); }

}  // namespace pcvt::plane
