#include "mesher/plane/interfaces/box_nodes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pcvt::plane {
namespace {

/// The longest way, in units of the shorter chord beside the node.
constexpr double kReach = 0.2;
/// Each round reduces the error about tenfold.
constexpr int kMostNodeRounds = 40;
/// In degrees.
constexpr double kSettled = 1e-13;

/// A node that is to lie on a side of the box.
struct Pin {
    std::size_t node;
    int axis;
    double line;
};

class EllipseSlide {
   public:
    EllipseSlide(const InclusionSet& set, const EllipseAxes& ellipse, std::vector<double>& degrees)
        : set_(set), ellipse_(ellipse), degrees_(degrees) {}

    void run() {
        scale_ = scale_to_area(ellipse_, degrees_);
        const std::vector<Pin> pins = find_pins();
        for (int round = 0; round < kMostNodeRounds; ++round) {
            double largest = 0;
            for (const Pin& pin : pins) {
                const double step = step_to(pin);
                degrees_[pin.node] += step;
                largest = std::max(largest, std::abs(step));
            }
            if (largest <= kSettled) break;
            scale_ = scale_to_area(ellipse_, degrees_);
        }
    }

   private:
    Vec2 scaled(double degrees) const {
        return ellipse_.centre + scale_ * (ellipse_.at_degrees(degrees) - ellipse_.centre);
    }
    /// The Newton step to a line, degrees.
    double step_to(const Pin& pin) const {
        const double degrees = degrees_[pin.node];
        const double at = *set_.box_coordinate(scaled(degrees), pin.axis);
        const double slope = *set_.box_coordinate(scaled(degrees + 90), pin.axis) -
                             *set_.box_coordinate(ellipse_.centre, pin.axis);
        return (pin.line - at) / slope * (180 / std::numbers::pi);
    }
    double gap_after(std::size_t m) const {
        const bool is_last = m + 1 == degrees_.size();
        return is_last ? degrees_[0] + 360 - degrees_[m] : degrees_[m + 1] - degrees_[m];
    }

    std::vector<Pin> find_pins() const {
        std::vector<Pin> pins;
        for (std::size_t m = 0; m < degrees_.size(); ++m) {
            double least =
                kReach * std::min(gap_after(m), gap_after(m == 0 ? degrees_.size() - 1 : m - 1));
            std::optional<Pin> nearest;
            for (int axis = 0; axis < 2; ++axis) {
                const double at = *set_.box_coordinate(scaled(degrees_[m]), axis);
                const Pin pin{m, axis, std::round(at)};
                const double step = std::abs(step_to(pin));
                if (!(step <= least)) continue;
                least = step;
                nearest = pin;
            }
            if (nearest) pins.push_back(*nearest);
        }
        return pins;
    }

    const InclusionSet& set_;
    const EllipseAxes& ellipse_;
    std::vector<double>& degrees_;
    double scale_ = 1;
};

}  // namespace

double scale_to_area(const EllipseAxes& ellipse, const std::vector<double>& degrees) {
    Polygon chords;
    for (const double t : degrees) chords.push_back(ellipse.at_degrees(t) - ellipse.centre);
    return std::sqrt(std::numbers::pi * ellipse.a * ellipse.b / polygon_area(chords));
}

void slide_onto_box(const InclusionSet& set, const EllipseAxes& ellipse,
                    std::vector<double>& degrees) {
    if (set.has_box()) EllipseSlide(set, ellipse, degrees).run();
}

void slide_onto_box(const InclusionSet& set, const Vec2& from, const Vec2& along,
                    std::vector<double>& places) {
    if (!set.has_box()) return;
    const std::vector<double> before = places;
    for (std::size_t m = 1; m + 1 < places.size(); ++m) {
        double least = kReach * std::min(before[m] - before[m - 1], before[m + 1] - before[m]);
        for (int axis = 0; axis < 2; ++axis) {
            const double at = *set.box_coordinate(from + before[m] * along, axis);
            const double slope =
                *set.box_coordinate(from + along, axis) - *set.box_coordinate(from, axis);
            const double step = (std::round(at) - at) / slope;
            if (!(std::abs(step) <= least)) continue;
            least = std::abs(step);
            places[m] = before[m] + step;
        }
    }
}

}  // namespace pcvt::plane
