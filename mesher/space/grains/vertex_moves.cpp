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
/// The lattice directions of a pattern search: the axes and the diagonals of a cube.
const std::array<Vec3, 14> kSearchDirections{Vec3(1, 0, 0),
                                             Vec3(-1, 0, 0),
                                             Vec3(0, 1, 0),
                                             Vec3(0, -1, 0),
                                             Vec3(0, 0, 1),
                                             Vec3(0, 0, -1),
                                             Vec3(kDiagonal, kDiagonal, kDiagonal),
                                             Vec3(-kDiagonal, kDiagonal, kDiagonal),
                                             Vec3(kDiagonal, -kDiagonal, kDiagonal),
                                             Vec3(-kDiagonal, -kDiagonal, kDiagonal),
                                             Vec3(kDiagonal, kDiagonal, -kDiagonal),
                                             Vec3(-kDiagonal, kDiagonal, -kDiagonal),
                                             Vec3(kDiagonal, -kDiagonal, -kDiagonal),
                                             Vec3(-kDiagonal, -kDiagonal, -kDiagonal)};

}  // namespace

void VertexMoves::relax() {
    for (int v = cell_.n_hull(); v < cell_.n_vertices(); ++v) {
        if (cell_.is_used(v) && !cell_.has_failed(CellTetrahedra::kRelaxation, v)) {
            relax_vertex(v);
        }
    }
}

void VertexMoves::relax_vertex(int v) {
    cell_.find_star(v, star_);
    double least = kFloor;
    shape_.clear();
    for (const int t : star_) {
        least = std::min(least, cell_.quality(t));
        shape_.add(cell_, t, v);
    }
    const double ratio = kRatioGain * shape_.measure(Vec3::Zero(), -kUnlimited).sum_of_ratios;
    const StarShape::Centres centres = shape_.centres();
    for (const Vec3& way : {centres.of_spheres, centres.of_corners, Vec3(centres.of_corners / 2)}) {
        const StarShape::Measure there = shape_.measure(way, least);
        if (!(there.least_quality >= least) || !(there.sum_of_ratios > ratio)) continue;
        cell_.set_point(v, cell_.point(v) + way);
        cell_.update_quality(star_);
        return;
    }
    cell_.note_failure(CellTetrahedra::kRelaxation, v);
}

/// The mean of the corners of the star, weighted by their tetrahedra, and the length of the
/// shortest edge at v; both from v.
std::pair<Vec3, double> VertexMoves::middle_of_star(int v) const {
    Vec3 sum = Vec3::Zero();
    double shortest = kUnlimited;
    for (const int t : star_) {
        for (const int w : cell_.corners(t)) {
            if (w == v) continue;
            const Vec3 arm = difference(cell_.point(w), cell_.point(v));
            sum += arm;
            shortest = std::min(shortest, squared_length(arm));
        }
    }
    return {sum / static_cast<double>(3 * star_.size()), std::sqrt(shortest)};
}

bool VertexMoves::climb(int v, double target) {
    if (cell_.has_failed(CellTetrahedra::kMove, v)) return false;
    cell_.find_star(v, star_);
    // The worst tetrahedra come first, since most probes fail there.
    std::sort(star_.begin(), star_.end(), [&](int s, int t) {
        return cell_.quality(s) != cell_.quality(t) ? cell_.quality(s) < cell_.quality(t) : s < t;
    });
    const double start = cell_.quality(star_[0]);
    if (start > target) return false;
    shape_.clear();
    for (const int t : star_) shape_.add(cell_, t, v);
    double best = start;
    Vec3 way = Vec3::Zero();
    const auto probe = [&](const Vec3& other) {
        const double worst = shape_.least_quality(other, best);
        if (!(worst > best + kProbeGain)) return false;
        best = worst;
        way = other;
        return true;
    };
    const auto [middle, shortest] = middle_of_star(v);
    probe(middle);
    probe((way + middle) / 2);
    double step = kFirstStep * shortest;
    for (int k = 0; k < kStepLengths; ++k, step /= 2) {
        bool moved = false;
        for (const Vec3& direction : kSearchDirections) moved |= probe(way + step * direction);
        if (moved && k > 0) step *= 1.5;
    }
    if (best <= start + kMoveGain) {
        cell_.note_failure(CellTetrahedra::kMove, v);
        return false;
    }
    cell_.set_point(v, cell_.point(v) + way);
    cell_.update_quality(star_);
    return true;
}

}  // namespace pcvt::space
