#include "mesher/finite_volume/beltrami_flow.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>
#include <numbers>

#include "mesher/portable/portable_angles.hpp"

namespace pcvt {
namespace {

/// Reciprocal vectors whose lengths differ by less than this factor count as equally long.
constexpr double kEquallyLong = 1 + 1e-9;

}  // namespace

BeltramiFlow::BeltramiFlow(const space::Lattice& lattice) {
    const space::Lattice reduced = reduce(lattice).reduced;
    Eigen::Matrix3d periods;
    for (int k = 0; k < 3; ++k) periods.col(k) = reduced.periods()[k];
    const Eigen::Matrix3d reciprocal = 2 * std::numbers::pi * periods.inverse();
    const double shortest = reciprocal.rowwise().norm().minCoeff();
    for (int r = 0; r < 3; ++r) {
        const space::Vec3 k = reciprocal.row(r);
        if (k.norm() > kEquallyLong * shortest) continue;
        const space::Vec3 e = k.unitOrthogonal();
        waves_.push_back({k, e, k.normalized().cross(e)});
    }
    rate_ = shortest * shortest;
}

space::Vec3 BeltramiFlow::velocity(const space::Vec3& p) const {
    space::Vec3 sum = space::Vec3::Zero();
    for (const Wave& wave : waves_) {
        const auto [cos, sin] = cos_sin(wave.k.dot(p));
        sum += wave.e * cos + wave.f * sin;
    }
    return sum / static_cast<double>(waves_.size());
}

double BeltramiFlow::turn_time() const { return std::numbers::pi / 2 / std::sqrt(rate_); }

}  // namespace pcvt
