#include "mesher/space/geometry/metric.hpp"

#include <algorithm>
#include <cmath>

#include "mesher/base/error.hpp"
#include "mesher/portable/portable_functions.hpp"

namespace pcvt::space {
namespace {

/// The symmetric matrix that multiplies lengths along the unit vector `along` by `factor`, and by
/// `across` across it.
Eigen::Matrix3d stretch(const Vec3& along, double factor, double across) {
    Eigen::Matrix3d matrix;
    for (int r = 0; r < 3; ++r) {
        for (int c = 0; c < 3; ++c) {
            matrix(r, c) = (factor - across) * along[r] * along[c] + (r == c ? across : 0);
        }
    }
    return matrix;
}

/// The direction of an axis. Scaled first, so that no square overflows.
Vec3 unit_vector(const Vec3& axis) {
    const Vec3 scaled = axis / axis.cwiseAbs().maxCoeff();
    return scaled /
           std::sqrt(scaled.x() * scaled.x() + scaled.y() * scaled.y() + scaled.z() * scaled.z());
}

/// The factor of to_round() across the axis, the root of the ratio.
double factor_across(double ratio) { return portable_cbrt(ratio); }

}  // namespace

Metric::Metric(double ratio, const Vec3& axis) : is_round_(ratio == 1) {
    if (!(ratio >= 1 / kLargestRatio && ratio <= kLargestRatio)) {
        throw InvalidInput("the aspect ratio must lie between 0.01 and 100");
    }
    if (!axis.allFinite() || axis == Vec3::Zero()) {
        throw InvalidInput(
            "the axis of the aspect needs a direction; give three numbers, not all 0");
    }
    if (is_round_) return;
    ratio_ = ratio;
    axis_ = axis;
    const Vec3 along = unit_vector(axis);
    const double across = factor_across(ratio);
    b_ = stretch(along, across / ratio, across);
    inverse_ = stretch(along, ratio / across, 1 / across);
}

Points Metric::to_round(const Points& points) const {
    if (is_round_) return points;
    Points mapped(3, points.cols());
    for (Eigen::Index s = 0; s < points.cols(); ++s) mapped.col(s) = to_round(Vec3(points.col(s)));
    return mapped;
}

Lattice Metric::to_round(const Lattice& lattice) const {
    if (is_round_) return lattice;
    return {to_round(lattice.a()), to_round(lattice.b()), to_round(lattice.c())};
}

void Metric::require_reducible(const Lattice& lattice) const { reduce(to_round(lattice)); }

double Metric::largest_stretch() const {
    const double across = factor_across(ratio_);
    return std::max(across, across / ratio_);
}

double Metric::largest_stretch_back() const {
    const double across = factor_across(ratio_);
    return std::max(1 / across, ratio_ / across);
}

Sites Metric::from_round(const Sites& round, const Lattice& lattice) const {
    const std::array<int, 9>& m = round.reduction().m;
    const auto period = [&](int r) {
        return lattice.translation({m[3 * r], m[3 * r + 1], m[3 * r + 2]});
    };
    return {lattice, Reduction{Lattice(period(0), period(1), period(2)), m}, round.coordinates()};
}

}  // namespace pcvt::space
