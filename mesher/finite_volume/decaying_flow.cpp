#include "mesher/finite_volume/decaying_flow.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mesher/portable/portable_angles.hpp"

namespace pcvt {
namespace {

/// The largest cosine between period vectors that count as rectangular. It admits the rounding
/// error of the reduction, which may magnify the error of a decimal input by 10^6.
constexpr double kRectangular = 1e-9;

double square(double value) { return value * value; }

}  // namespace

DecayingFlow::DecayingFlow(const plane::Lattice& lattice, Walls walls) {
    if (walls == Walls::kNone) {
        choose_periodic(lattice);
    } else {
        choose_between(lattice, walls);
    }
}

void DecayingFlow::choose_periodic(const plane::Lattice& lattice) {
    const plane::Lattice basis = reduce(lattice).reduced;
    const plane::Vec2& a = basis.a();
    const plane::Vec2& b = basis.b();
    const double per_area = 2 * std::numbers::pi / basis.area();
    g1_ = per_area * plane::Vec2(b.y(), -b.x());
    g2_ = per_area * plane::Vec2(-a.y(), a.x());
    const bool rectangular = std::abs(a.normalized().dot(b.normalized())) < kRectangular;
    shape_ = rectangular ? Shape::kVortices : Shape::kShear;
    fastest_ = rectangular ? g1_.norm() : g2_.norm();
}

void DecayingFlow::choose_between(const plane::Lattice& domain, Walls walls) {
    g1_ = plane::Vec2(std::numbers::pi / side_length(domain, 0), 0);
    g2_ = plane::Vec2(0, std::numbers::pi / side_length(domain, 1));
    shape_ = walls == Walls::kXY ? Shape::kBox : Shape::kShear;
    if (walls == Walls::kX) g2_ = g1_;
    if (walls == Walls::kY) sign_ = -1;
    fastest_ = shape_ == Shape::kBox ? std::max(g1_.norm(), g2_.norm()) : g2_.norm();
}

plane::Vec2 DecayingFlow::velocity(const plane::Vec2& p) const {
    const double first = g1_.dot(p);
    const double second = g2_.dot(p);
    plane::Vec2 gradient = -portable_sin(second) * g2_;
    if (shape_ == Shape::kVortices) {
        gradient = -portable_sin(first) * portable_cos(second) * g1_ -
                   portable_cos(first) * portable_sin(second) * g2_;
    } else if (shape_ == Shape::kBox) {
        gradient = portable_sin(2 * first) * square(portable_sin(second)) * g1_ +
                   square(portable_sin(first)) * portable_sin(2 * second) * g2_;
    }
    return sign_ * plane::Vec2(gradient.y(), -gradient.x()) / fastest_;
}

double DecayingFlow::stream(const plane::Vec2& p) const {
    double value = portable_cos(g2_.dot(p));
    if (shape_ == Shape::kVortices) value *= portable_cos(g1_.dot(p));
    if (shape_ == Shape::kBox) value = square(portable_sin(g1_.dot(p)) * portable_sin(g2_.dot(p)));
    return sign_ * value / fastest_;
}

double DecayingFlow::mean_square_speed() const {
    const double both = (g1_.squaredNorm() + g2_.squaredNorm()) / square(fastest_);
    if (shape_ == Shape::kBox) return 3.0 / 16 * both;
    return shape_ == Shape::kVortices ? both / 4 : 0.5;
}

double DecayingFlow::rate() const {
    const double first = g1_.squaredNorm();
    const double second = g2_.squaredNorm();
    if (shape_ == Shape::kShear) return second;
    if (shape_ == Shape::kVortices) return first + second;
    return 4 * (first * first + second * second + 2.0 / 3 * first * second) / (first + second);
}

double DecayingFlow::turn_time() const { return std::numbers::pi / 2 / fastest_; }

}  // namespace pcvt
