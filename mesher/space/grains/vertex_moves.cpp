#include "mesher/space/grains/vertex_moves.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace pcvt::space {
namespace {

/// relax() lets sines fall down to that of 30 degrees.
constexpr double kFloor = 0.5;
/// The sum of volume-length ratios grows at least by this factor.
constexpr double kRatioGain = 1.0001;
/// The smallest sine grows at least by this much.
constexpr double kProbeGain = 1e-9;
constexpr double kMoveGain = 1e-6;
/// The first step of a search over the shortest edge of the star, and the number of step lengths.
constexpr double kFirstStep = 0.25;
constexpr int kStepLengths = 3;
constexpr double kDiagonal = 0.5773502691896258;

double ratio_of(const CellTetrahedra& cell, int t, int v, const Vec3& at) {
    const FourCorners& c = cell.corners(t);
    const auto corner = [&](int k) -> const Vec3& { return c[k] == v ? at : cell.point(c[k]); };
    return volume_length_ratio(corner(0), corner(1), corner(2), corner(3));
}

double volume6_of(const CellTetrahedra& cell, int t) {
    const FourCorners& c = cell.corners(t);
    return volume6(cell.point(c[0]), cell.point(c[1]), cell.point(c[2]), cell.point(c[3]));
}

}  // namespace

Vec3 search_direction(int k) {
    if (k < 6) {
        Vec3 axis = Vec3::Zero();
        axis[k / 2] = k % 2 == 0 ? 1 : -1;
        return axis;
    }
    const int signs = k - 6;
    const auto coordinate = [&](int bit) {
        return (signs >> bit & 1) == 0 ? kDiagonal : -kDiagonal;
    };
    return {coordinate(0), coordinate(1), coordinate(2)};
}

void VertexMoves::relax() {
    for (int v = cell_.n_hull(); v < cell_.n_vertices(); ++v) {
        if (cell_.is_used(v)) relax_vertex(v);
    }
}

void VertexMoves::relax_vertex(int v) {
    cell_.find_star(v, star_);
    double volume = 0;
    double ratio = 0;
    double least = kFloor;
    Vec3 centres = Vec3::Zero();
    Vec3 barycentres = Vec3::Zero();
    for (const int t : star_) {
        ratio += ratio_of(cell_, t, v, cell_.point(v));
        least = std::min(least, cell_.quality(t));
        const Circumsphere sphere = cell_.circumsphere_of(t);
        if (!std::isfinite(sphere.radius)) continue;
        const double part = volume6_of(cell_, t);
        volume += part;
        centres += part * sphere.centre;
        barycentres += part * cell_.barycentre(t);
    }
    const Vec3 middle = barycentres / volume;
    const std::array<Vec3, 3> candidates{centres / volume, middle, (cell_.point(v) + middle) / 2};
    for (const Vec3& x : candidates) {
        if (!is_better(v, x, least, kRatioGain * ratio)) continue;
        cell_.set_point(v, x);
        cell_.update_quality(star_);
        return;
    }
}

bool VertexMoves::is_better(int v, const Vec3& at, double least, double ratio) const {
    double sum = 0;
    for (const int t : star_) {
        if (!(cell_.quality_with(t, v, at) >= least)) return false;
        sum += ratio_of(cell_, t, v, at);
    }
    return sum > ratio;
}

double VertexMoves::worst_with(int v, const Vec3& at, double least) const {
    double worst = kUnlimited;
    for (const int t : star_) {
        worst = std::min(worst, cell_.quality_with(t, v, at));
        if (worst <= least) break;
    }
    return worst;
}

bool VertexMoves::climb(int v, double target) {
    cell_.find_star(v, star_);
    // The worst tetrahedra come first, since most probes fail there.
    std::sort(star_.begin(), star_.end(), [&](int s, int t) {
        return cell_.quality(s) != cell_.quality(t) ? cell_.quality(s) < cell_.quality(t) : s < t;
    });
    const double start = cell_.quality(star_[0]);
    if (start > target) return false;
    double best = start;
    Vec3 x = cell_.point(v);
    const auto probe = [&](const Vec3& at) {
        const double worst = worst_with(v, at, best);
        if (!(worst > best + kProbeGain)) return false;
        best = worst;
        x = at;
        return true;
    };
    Vec3 sum = Vec3::Zero();
    double shortest = kUnlimited;
    for (const int t : star_) {
        for (const int w : cell_.corners(t)) {
            if (w == v) continue;
            sum += cell_.point(w);
            shortest = std::min(shortest, squared_distance(cell_.point(w), x));
        }
    }
    const Vec3 middle = sum / static_cast<double>(3 * star_.size());
    probe(middle);
    probe((x + middle) / 2);
    double step = kFirstStep * std::sqrt(shortest);
    for (int k = 0; k < kStepLengths; ++k, step /= 2) {
        bool moved = false;
        for (int d = 0; d < kSearchDirections; ++d) {
            moved |= probe(x + step * search_direction(d));
        }
        if (moved && k > 0) step *= 1.5;
    }
    if (best <= start + kMoveGain) return false;
    cell_.set_point(v, x);
    cell_.update_quality(star_);
    return true;
}

}  // namespace pcvt::space
