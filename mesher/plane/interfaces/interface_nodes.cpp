#include "mesher/plane/interfaces/interface_nodes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "mesher/base/checkpoint.hpp"
#include "mesher/base/error.hpp"
#include "mesher/plane/interfaces/box_nodes.hpp"
#include "mesher/plane/interfaces/curve_samples.hpp"

namespace pcvt::plane {
namespace {

/// The radius of a circle over the length of its chords. The seeds then lie half a chord from it.
const double kRadiusPerChord = std::sqrt(0.5);
/// The longest chord over the width of a gap, in which two rows of seeds face each other.
constexpr double kChordPerGap = 0.6;
/// Over the radius of the largest circle inside that touches there.
constexpr double kChordPerCurve = 1.0;
constexpr double kFewestChords = 6;

/// For fewer seeds, the placement itself is fast, and names a number of sites that suffices.
constexpr double kManySeeds = 10'000;
/// The square of the longest chord over the shortest one and the radius. Scaling moves a circle's
/// chords by l^2 / (12 R): by an eighth of the narrowest gap.
constexpr double kCurvedPerGap = 2.5;
/// Samples per chord, and the largest step in degrees.
constexpr double kSamples = 4;
constexpr double kLargestStep = 10;
constexpr std::size_t kMostSamples = 10'000'000;
/// A corner with a smaller angle on one side gets a seed on its bisector there: 115 degrees, as the
/// tangent of the half.
const double kSharp = 1.57;
/// The longest chord at a sharp corner over its side, and the longest chord in its wedge over the
/// distance from the tip and the tangent of half of the angle.
constexpr double kTipPerSide = 0.36;
constexpr double kChordPerWedge = 1.5;
/// Rounds up the number of chords on a side of a polygon only from this part of a chord on.
constexpr double kSpareChord = 0.25;

/// Sizes at points of one curve.
class CurveSizes {
   public:
    CurveSizes(const InclusionSet& set, int k, const InterfaceSizing& sizing)
        : set_(set), k_(k), sizing_(sizing), limits_(sizing.limits[k]) {}

    /// @param most  a bound from the curve itself.
    double at(const Vec2& p, double most) const {
        const double size = std::min({most, sizing_.spacing(p), limits_.at(p)});
        return kChordPerGap * set_.distance_to_others(k_, p, size / kChordPerGap);
    }

    void require_few(std::size_t n_samples) const {
        checkpoint_each(static_cast<long>(n_samples));
        if (n_samples < kMostSamples) return;
        throw BadInclusion(set_[k_].line,
                           "a gap beside the shape is too narrow; move the shapes apart");
    }

   private:
    const InclusionSet& set_;
    int k_;
    const InterfaceSizing& sizing_;
    SizeLimits limits_;
};

/// Sets the radii of nodes that have none from their two chords.
void set_radii(std::vector<InterfaceNode>& nodes) {
    const std::size_t n = nodes.size();
    for (std::size_t k = 0; k < n; ++k) {
        if (nodes[k].radius > 0) continue;
        const double before = (nodes[k].point - nodes[(k + n - 1) % n].point).norm();
        const double after = (nodes[(k + 1) % n].point - nodes[k].point).norm();
        nodes[k].radius = kRadiusPerChord * std::sqrt(before * after);
    }
}

std::vector<Sample> ellipse_samples(const EllipseAxes& ellipse, const CurveSizes& sizes) {
    std::vector<Sample> samples;
    double degrees = 0;
    double along = 0;
    Vec2 before = ellipse.at_degrees(0);
    for (;;) {
        const Vec2 p = ellipse.at_degrees(degrees);
        const Vec2 d = p - ellipse.centre;
        const double x = d.dot(ellipse.along) / ellipse.a;
        const double y = cross(ellipse.along, d) / ellipse.b;
        // dp / dt; times b / a it is the radius of the largest circle inside that touches at p.
        const double speed = Vec2(ellipse.a * y, ellipse.b * x).norm();
        const double inner = speed * ellipse.b / ellipse.a;
        along += (p - before).norm();
        samples.push_back({degrees, along, sizes.at(p, kChordPerCurve * inner)});
        sizes.require_few(samples.size());
        if (degrees == 360) return samples;
        const double step = samples.back().size / kSamples / speed * (180 / std::numbers::pi);
        degrees = std::min(360.0, degrees + std::min(step, kLargestStep));
        before = p;
    }
}

std::vector<InterfaceNode> ellipse_nodes(const InclusionSet& set, const EllipseAxes& ellipse,
                                         const CurveSizes& sizes) {
    std::vector<Sample> samples = ellipse_samples(ellipse, sizes);
    // Chords that leave out less area need less scaling, which would close the narrowest gap.
    double least = samples[0].size;
    for (const Sample& sample : samples) least = std::min(least, sample.size);
    const double most = std::sqrt(kCurvedPerGap * least * ellipse.a);
    for (Sample& sample : samples) sample.size = std::min(sample.size, most);
    grade(samples);
    const std::vector<double> counts = chord_counts(samples);
    const auto n = static_cast<std::size_t>(std::max(kFewestChords, std::ceil(counts.back())));
    std::vector<double> degrees;
    for (std::size_t k = 0; k < n; ++k) {
        const double at = counts.back() * static_cast<double>(k) / static_cast<double>(n);
        degrees.push_back(interpolated(
            at, samples, [&](std::size_t m) { return counts[m]; },
            [&](std::size_t m) { return samples[m].parameter; }));
    }
    slide_onto_box(set, ellipse, degrees);
    const double scale = scale_to_area(ellipse, degrees);
    std::vector<InterfaceNode> nodes;
    for (const double t : degrees) {
        nodes.push_back({ellipse.centre + scale * (ellipse.at_degrees(t) - ellipse.centre), 0});
    }
    set_radii(nodes);
    return nodes;
}

/// Twice the radius of the smallest circle that touches the line through p with the normal n at p
/// and the segment, on either side of the line.
double touching_width(const Vec2& p, const Vec2& n, const Vec2& from, const Vec2& to) {
    double width = std::numeric_limits<double>::infinity();
    for (const Vec2& end : {from, to}) {
        width = std::min(width, (end - p).squaredNorm() / std::abs(n.dot(end - p)));
    }
    const Vec2 side = (to - from).normalized();
    Vec2 m = turned_left(side);
    if (m.dot(from - p) < 0) m = -m;
    for (const Vec2& normal : {n, Vec2(-n)}) {
        // For parallel sides, rounding errors may make the denominator negative.
        const double radius = m.dot(from - p) / (1 + normal.dot(m));
        if (!(radius > 0 && radius < width / 2)) continue;
        const double at = side.dot(p + radius * (normal + m) - from);
        if (at >= 0 && at <= (to - from).norm()) width = 2 * radius;
    }
    return width;
}

/// The chords at a corner of a polygon.
struct CornerPlan {
    double size;
    /// Tangent of half of the sharper angle, and on which side it is: 0 if it is not sharp.
    double slope;
    int shared_side = 0;
    /// At a sharp corner, the radius, the length of both chords and the radius at their other ends.
    double radius = 0;
    double chord = 0;
    double next_radius = 0;
};

class PolygonNodes {
   public:
    PolygonNodes(const InclusionSet& set, int k, const Polygon& polygon, const CurveSizes& sizes)
        : set_(set), k_(k), polygon_(polygon), sizes_(sizes) {}

    std::vector<InterfaceNode> nodes() {
        for (std::size_t k = 0; k < n(); ++k) plans_.push_back(plan_of(k));
        sample();
        grade(samples_);
        std::vector<InterfaceNode> nodes;
        for (std::size_t k = 0; k < n(); ++k) add_side(k, nodes);
        set_radii(nodes);
        return nodes;
    }

   private:
    std::size_t n() const { return polygon_.size(); }
    const Vec2& corner(std::size_t k) const { return polygon_[k % n()]; }
    const CornerPlan& plan(std::size_t k) const { return plans_[k % n()]; }
    Vec2 side(std::size_t k) const { return corner(k + 1) - corner(k); }

    /// kChordPerGap times the least touching_width at a point of side k to sides that are not
    /// beside it.
    double size_of_gap(std::size_t k, const Vec2& p) const {
        const Vec2 along = side(k).normalized();
        const Vec2 normal = turned_left(along);
        const double infinite = std::numeric_limits<double>::infinity();
        const double width = set_.sides(k_).least(p, infinite, [&](std::size_t m) {
            const std::size_t after = m >= k ? m - k : m + n() - k;
            const bool is_beside = after <= 1 || after + 1 == n();
            return is_beside ? infinite : touching_width(p, normal, corner(m), corner(m + 1));
        });
        return kChordPerGap * width;
    }

    CornerPlan plan_of(std::size_t k) const {
        const Vec2 before = side(k + n() - 1);
        const Vec2 after = side(k);
        const double shorter = std::min(before.norm(), after.norm());
        const double bound = std::min(
            {shorter, size_of_gap(k, corner(k)), size_of_gap((k + n() - 1) % n(), corner(k))});
        CornerPlan plan{sizes_.at(corner(k), bound), 0};
        // The angle between the directions away from the corner.
        const Vec2 p = -before.normalized();
        const Vec2 q = after.normalized();
        const double slope = std::sqrt(std::max(0.0, (1 - p.dot(q)) / (1 + p.dot(q))));
        if (!(slope < kSharp)) return plan;
        // The seed on the bisector lies a foot along both sides from the corner.
        plan.slope = slope;
        plan.shared_side = cross(before, after) > 0 ? 1 : -1;
        const double excess = std::min(1.0, slope / 2 + 2 * slope * slope);
        const double wide = std::max(1.0, std::sqrt((1 + slope * slope) / 2));
        const double foot = std::min(plan.size / (2 * wide), kTipPerSide * shorter / (1 + excess));
        plan.radius = foot * std::sqrt(1 + slope * slope);
        plan.chord = foot * (1 + excess);
        plan.next_radius = foot * std::sqrt(excess * excess + slope * slope);
        return plan;
    }

    double size_on_side(std::size_t k, double from_start) const {
        const double length = side(k).norm();
        const Vec2 p = corner(k) + from_start / length * side(k);
        double bound = size_of_gap(k, p);
        const auto wedge = [&](const CornerPlan& plan, double from_tip) {
            if (plan.shared_side == 0) return;
            bound = std::min(bound, kChordPerWedge * plan.slope * std::max(from_tip, plan.chord));
        };
        wedge(plan(k), from_start);
        wedge(plan(k + 1), length - from_start);
        return sizes_.at(p, bound);
    }

    void sample() {
        double start = 0;
        for (std::size_t k = 0; k < n(); ++k) {
            first_.push_back(samples_.size());
            const double length = side(k).norm();
            samples_.push_back({0, start, plan(k).size});
            for (double at = 0; at < length;) {
                const double step = samples_.back().size / kSamples;
                at = at + step < length ? at + step : length;
                const double size = at < length ? size_on_side(k, at) : plan(k + 1).size;
                samples_.push_back({at, start + at, size});
                sizes_.require_few(samples_.size());
            }
            start += length;
        }
        first_.push_back(samples_.size());
    }

    /// Adds the nodes from corner k up to the next corner, which is left out.
    void add_side(std::size_t k, std::vector<InterfaceNode>& nodes) const {
        const double length = side(k).norm();
        const Vec2 along = side(k) / length;
        const double from = plan(k).chord;
        const double to = length - plan(k + 1).chord;
        nodes.push_back({corner(k), plan(k).radius, plan(k).shared_side});
        if (from > 0) nodes.push_back({corner(k) + from * along, plan(k).next_radius});
        // Divide the part between the chords of sharp corners.
        const std::vector<Sample> samples(samples_.begin() + static_cast<long>(first_[k]),
                                          samples_.begin() + static_cast<long>(first_[k + 1]));
        const std::vector<double> counts = chord_counts(samples);
        const auto count = [&](std::size_t m) { return counts[m]; };
        const auto place = [&](std::size_t m) { return samples[m].parameter; };
        const double first = interpolated(from, samples, place, count);
        const double last = interpolated(to, samples, place, count);
        const double n_chords = std::max(1.0, std::ceil(last - first - kSpareChord));
        std::vector<double> places{from};
        for (double m = 1; m < n_chords; ++m) {
            places.push_back(
                interpolated(first + (last - first) * m / n_chords, samples, count, place));
        }
        places.push_back(to);
        slide_onto_box(set_, corner(k), along, places);
        for (std::size_t m = 1; m + 1 < places.size(); ++m) {
            nodes.push_back({corner(k) + places[m] * along, 0});
        }
        if (to < length) nodes.push_back({corner(k) + to * along, plan(k + 1).next_radius});
    }

    const InclusionSet& set_;
    int k_;
    const Polygon& polygon_;
    const CurveSizes& sizes_;
    std::vector<CornerPlan> plans_;
    std::vector<Sample> samples_;
    /// The first sample of each side, and after the last side the number of samples.
    std::vector<std::size_t> first_;
};

}  // namespace

double fewest_seeds(const Shape& shape) {
    // Each side of a polygon has a chord.
    if (const auto* polygon = std::get_if<Polygon>(&shape)) {
        return 2 * static_cast<double>(polygon->size());
    }
    const auto* circle = std::get_if<Circle>(&shape);
    const EllipseAxes axes =
        circle ? ellipse_axes(*circle) : ellipse_axes(std::get<Ellipse>(shape));
    if (!(axes.b > 0)) return 0;
    // The integral of 1 / kChordPerCurve / inner (ellipse_samples) round the ellipse, less the
    // rounding of its samples.
    const double chords = 0.99 * 2 * std::numbers::pi * axes.a / axes.b / kChordPerCurve;
    return 2 * std::max(kFewestChords, std::ceil(chords));
}

void require_enough_sites(int n_sites, double n_seeds) {
    if (n_sites >= n_seeds || n_seeds < kManySeeds) return;
    throw InvalidInput(std::to_string(n_sites) + " sites are too few for the inclusions; take " +
                       std::to_string(static_cast<long>(n_seeds)) +
                       " or more, the least that their outlines need");
}

std::vector<InterfaceNode> interface_nodes(const InclusionSet& set, int k,
                                           const InterfaceSizing& sizing) {
    const CurveSizes sizes(set, k, sizing);
    const Shape& shape = set[k].shape;
    if (const auto* polygon = std::get_if<Polygon>(&shape)) {
        return PolygonNodes(set, k, *polygon, sizes).nodes();
    }
    const auto* circle = std::get_if<Circle>(&shape);
    return ellipse_nodes(
        set, circle ? ellipse_axes(*circle) : ellipse_axes(std::get<Ellipse>(shape)), sizes);
}

}  // namespace pcvt::plane
