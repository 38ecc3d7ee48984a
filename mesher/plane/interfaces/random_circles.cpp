#include "mesher/plane/interfaces/random_circles.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "mesher/base/checkpoint.hpp"
#include "mesher/base/error.hpp"
#include "mesher/plane/geometry/sites.hpp"
#include "mesher/plane/geometry/walled_domain.hpp"
#include "mesher/plane/interfaces/torus_grid.hpp"

namespace pcvt::plane {
namespace {

/// The part of the gap and the diameter at which circles begin, and the sweeps in which they grow.
constexpr double kFirstDiameter = 0.6;
constexpr int kGrowth = 60;
constexpr int kMostSweeps = 1500;
constexpr int kMostStarts = 6;
/// Circles repel each other up to a distance that is larger by this part than wanted, so that the
/// wanted distance is reached after finitely many sweeps.
constexpr double kDistanceReserve = 1e-3;
/// Points in a grid of the sweep's begin are looked up this much farther away.
constexpr double kStale = 1.3;
/// The area fraction of touching circles in hexagonal order.
const double kDensest = std::numbers::pi / std::sqrt(12.0);
/// In units of the radius.
constexpr std::array kDefaultGaps{0.2, 0.1, 0.05};

/// Points on the torus, or between walls, that repel each other.
class Repulsion {
   public:
    /// @param reduced  upright if there are walls.
    /// @param margin   the least distance from walls, length units.
    Repulsion(const Lattice& reduced, Points places, Walls walls, double margin)
        : reduced_(reduced), places_(std::move(places)), walls_(walls), margin_(margin) {
        keep_from_walls();
    }

    const Points& places() const { return places_; }

    /// Moves apart, one after another, the pairs nearer to each other than `distance`.
    void sweep(double distance) {
        visit_pairs(kStale * distance, [&](int i, int j, Offset offset) {
            const Vec2 d = way(i, j, offset);
            const double length = d.norm();
            if (length >= distance) return;
            const Vec2 unit = length > 0 ? Vec2(d / length) : Vec2(1, 0);
            const Vec2 move = reduced_.to_lattice((distance - length) / 2 * unit);
            places_.col(i) -= move;
            places_.col(j) += move;
        });
        keep_from_walls();
    }
    bool are_apart(double distance) {
        bool apart = true;
        visit_pairs(distance, [&](int i, int j, Offset offset) {
            apart = apart && way(i, j, offset).norm() >= distance;
        });
        return apart;
    }

   private:
    void keep_from_walls() {
        for (int axis = 0; axis < 2; ++axis) {
            if (!has_walls_across(walls_, axis)) continue;
            const double least = margin_ / side_length(reduced_, axis);
            places_.row(axis) = places_.row(axis).cwiseMax(least).cwiseMin(1 - least);
        }
    }
    bool crosses_wall(Offset offset) const {
        return (has_walls_across(walls_, 0) && offset.i != 0) ||
               (has_walls_across(walls_, 1) && offset.j != 0);
    }
    Vec2 way(int i, int j, Offset offset) const {
        return reduced_.to_position(places_.col(j) + Vec2(offset.i, offset.j) - places_.col(i));
    }
    /// Wraps all points and calls visit(i, j, offset) for the pairs that may be as near as
    /// `distance`, i < j.
    template <class Visit>
    void visit_pairs(double distance, const Visit& visit) {
        const auto n = static_cast<int>(places_.cols());
        TorusGrid grid(reduced_, n);
        for (int k = 0; k < n; ++k) {
            places_.col(k) -= Vec2(std::floor(places_(0, k)), std::floor(places_(1, k)));
            grid.add(k, places_.col(k));
        }
        for (int i = 0; i < n; ++i) {
            checkpoint_each(i);
            const Vec2 from = places_.col(i);
            grid.visit(from, distance, [&](int j, Offset offset) {
                if (i < j && !crosses_wall(offset)) visit(i, j, offset);
            });
        }
    }

    Lattice reduced_;
    Points places_;
    Walls walls_;
    double margin_;
};

void require(bool condition, const std::string& what) {
    if (!condition) throw InvalidInput(what);
}

/// The distances that centres of circles keep.
struct Distances {
    double from_centres;
    double from_walls;
};

/// Whether one circle has room between walls and beside its own images.
bool has_room(const Lattice& reduced, Walls walls, const Distances& distances) {
    if (walls == Walls::kNone) return distances.from_centres < reduced.a().norm();
    bool fits = true;
    for (int axis = 0; axis < 2; ++axis) {
        const bool is_walled = has_walls_across(walls, axis);
        const double needed = is_walled ? 2 * distances.from_walls : distances.from_centres;
        fits = fits && needed < side_length(reduced, axis);
    }
    return fits;
}

/// Returns the centres of circles at the distances, or nullopt if they find no place.
std::optional<std::vector<Vec2>> separated_points(const Lattice& reduced,
                                                  const RandomCircles& wanted, std::uint64_t seed,
                                                  Walls walls, const Distances& distances) {
    const double distance = distances.from_centres;
    const double fraction =
        wanted.n * std::numbers::pi * distance * distance / (4 * reduced.area());
    const bool is_dense = walls == Walls::kNone && !(fraction < kDensest);
    if (is_dense || !has_room(reduced, walls, distances)) return std::nullopt;
    for (int start = 0; start < kMostStarts; ++start) {
        // Starts of one seed and those of the next share no random numbers.
        const std::uint64_t number = seed * 0x9e3779b97f4a7c15u + std::uint64_t(start);
        Repulsion repulsion(reduced, uniform_points(Lattice::rectangle(1, 1), wanted.n, number),
                            walls, distances.from_walls);
        for (int sweep = 0; sweep < kMostSweeps; ++sweep) {
            const double grown = kFirstDiameter + (1 - kFirstDiameter) * sweep / kGrowth;
            repulsion.sweep((1 + kDistanceReserve) * std::min(1.0, grown) * distance);
            if (sweep < kGrowth || !repulsion.are_apart(distance)) continue;
            std::vector<Vec2> points;
            for (const auto& place : repulsion.places().colwise()) {
                points.push_back(reduced.to_position(place));
            }
            return points;
        }
    }
    return std::nullopt;
}

}  // namespace

std::vector<Circle> random_circles(const Lattice& lattice, const RandomCircles& wanted,
                                   std::uint64_t seed, Walls walls) {
    require(wanted.fraction > 0 && wanted.fraction < 1,
            "the area fraction must be between 0 and 1");
    require(wanted.n >= 1 && wanted.n <= kMostSites,
            "the number of circles must be between 1 and 2^28");
    require(!wanted.gap || (*wanted.gap > 0 && std::isfinite(*wanted.gap)),
            "the gap between circles must be positive");
    const double radius = std::sqrt(wanted.fraction * lattice.area() / wanted.n / std::numbers::pi);
    std::vector<double> gaps;
    if (wanted.gap) gaps.push_back(*wanted.gap);
    for (const double gap : kDefaultGaps) {
        if (!wanted.gap) gaps.push_back(gap * radius);
    }
    const bool has_walls = walls != Walls::kNone;
    const Lattice reduced = has_walls ? lattice : reduce(lattice).reduced;
    for (const double gap : gaps) {
        const auto points =
            separated_points(reduced, wanted, seed, walls, {2 * radius + gap, radius + gap});
        if (!points) continue;
        std::vector<Circle> circles;
        for (const Vec2& point : *points) circles.push_back({point, radius});
        return circles;
    }
    throw InvalidInput("no place was found for " + std::to_string(wanted.n) +
                       " circles with these gaps; take a smaller area fraction or gap");
}

}  // namespace pcvt::plane
