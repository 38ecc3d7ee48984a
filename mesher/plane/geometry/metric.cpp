#include "mesher/plane/geometry/metric.hpp"

#include <algorithm>
#include <cmath>

#include "mesher/base/error.hpp"
#include "mesher/portable/portable_angles.hpp"

namespace pcvt::plane {
namespace {

/// The symmetric matrix that multiplies lengths along the unit vector `along` by `factor` and
/// across it by 1 / factor.
Eigen::Matrix2d stretch(const Vec2& along, double factor) {
    const Vec2 across(-along.y(), along.x());
    return factor * along * along.transpose() + across * across.transpose() / factor;
}

}  // namespace

Metric::Metric(double ratio, double degrees) : is_round_(ratio == 1) {
    if (!(ratio >= 1 / kLargestRatio && ratio <= kLargestRatio)) {
        throw InvalidInput("the aspect ratio must lie between 0.01 and 100");
    }
    if (!std::isfinite(degrees)) throw InvalidInput("the angle of the aspect must be finite");
    if (is_round_) return;
    ratio_ = ratio;
    degrees_ = degrees;
    const CosSin angle = cos_sin_of_degrees(degrees);
    const Vec2 along(angle.cos, angle.sin);
    const double root = std::sqrt(ratio);
    b_ = stretch(along, 1 / root);
    inverse_ = stretch(along, root);
}

Points Metric::to_round(const Points& points) const {
    if (is_round_) return points;
    return b_ * points;
}

Lattice Metric::to_round(const Lattice& lattice) const {
    if (is_round_) return lattice;
    return {to_round(lattice.a()), to_round(lattice.b())};
}

void Metric::require_reducible(const Lattice& lattice) const { reduce(to_round(lattice)); }

double Metric::largest_stretch() const { return std::sqrt(std::max(ratio_, 1 / ratio_)); }

}  // namespace pcvt::plane
