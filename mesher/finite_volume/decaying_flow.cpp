#include "mesher/finite_volume/decaying_flow.hpp"

#include <cmath>
#include <numbers>

namespace pcvt {
namespace {

/// The largest cosine between period vectors that count as rectangular. It admits the rounding
/// error of the reduction, which may magnify the error of a decimal input by 10^6.
constexpr double kRightAngle = 1e-9;

}  // namespace

DecayingFlow::DecayingFlow(const Lattice& lattice) {
    const Lattice basis = reduce(lattice).reduced;
    const Vec2& a = basis.a();
    const Vec2& b = basis.b();
    const double per_area = 2 * std::numbers::pi / basis.area();
    g1_ = per_area * Vec2(b.y(), -b.x());
    g2_ = per_area * Vec2(-a.y(), a.x());
    rectangular_ = std::abs(a.normalized().dot(b.normalized())) < kRightAngle;
    rate_ = rectangular_ ? g1_.squaredNorm() + g2_.squaredNorm() : g2_.squaredNorm();
    fastest_ = rectangular_ ? g1_.norm() : g2_.norm();
}

Vec2 DecayingFlow::velocity(const Vec2& p) const {
    const double second = g2_.dot(p);
    Vec2 gradient = -std::sin(second) * g2_;
    if (rectangular_) {
        const double first = g1_.dot(p);
        gradient =
            -std::sin(first) * std::cos(second) * g1_ - std::cos(first) * std::sin(second) * g2_;
    }
    return Vec2(gradient.y(), -gradient.x()) / fastest_;
}

double DecayingFlow::stream(const Vec2& p) const {
    return (rectangular_ ? std::cos(g1_.dot(p)) : 1) * std::cos(g2_.dot(p)) / fastest_;
}

double DecayingFlow::mean_square_speed() const {
    return rate_ / ((rectangular_ ? 4 : 2) * fastest_ * fastest_);
}

double DecayingFlow::turn_time() const { return std::numbers::pi / 2 / fastest_; }

}  // namespace pcvt
