#include "mesher/plane/geometry/lattice.hpp"

#include <cmath>
#include <cstdlib>
#include <string>

#include "mesher/base/error.hpp"

namespace pcvt::plane {
namespace {

/// F has the unit length^4; it would leave the range of a double beyond these lengths.
constexpr double kShortestPeriod = 1e-60;
constexpr double kLongestPeriod = 1e60;
constexpr double kLargestCoefficient = 1e6;
constexpr double kThinnestBasis = 1e6;
/// Relative to |a| |b|; the sign of a smaller det(a, b) is rounding.
constexpr double kParallel = 1e-14;
/// Bases whose lengths differ by less than this factor count as equally short; otherwise rounding
/// could make the reduction alternate between them.
constexpr double kTie = 1 + 1e-12;

/// Whether x y is zero because x or y is.
bool is_without(double x, double y, double product) { return product == 0 && (x == 0 || y == 0); }

/// a b + c d within 1.5 ulp (W. Kahan's compensated product sum).
double product_sum(double a, double b, double c, double d) {
    const double ab = a * b;
    const double cd = c * d;
    // In rectangles one product is zero; then the sum below is the other product, rounded, and a
    // sum of zeros is not negative. Many machines compute fma() by a slow function.
    if (is_without(a, b, ab) || is_without(c, d, cd)) return ab + cd + 0.0;
    const double error = std::fma(c, d, -cd);
    return std::fma(a, b, cd) + error;
}

double determinant(const Vec2& p, const Vec2& q) {
    return product_sum(p.x(), q.y(), -p.y(), q.x());
}

void require_period(const Vec2& period) {
    if (!period.allFinite()) {
        throw InvalidInput("a period vector is not finite; give finite numbers");
    }
    const double length = period.norm();
    if (!(length >= kShortestPeriod && length <= kLongestPeriod)) {
        throw InvalidInput(
            "a period vector is shorter than 1e-60 or longer than 1e60; choose another unit of "
            "length");
    }
}

/// A basis a', b' as integer combinations of the basis of `lattice`; m as in Reduction.
struct Combination {
    const Lattice& lattice;
    std::array<std::int64_t, 4> m{1, 0, 0, 1};

    Vec2 vector(int row) const {
        const auto i = static_cast<double>(m[2 * row]);
        const auto j = static_cast<double>(m[2 * row + 1]);
        return {product_sum(i, lattice.a().x(), j, lattice.b().x()),
                product_sum(i, lattice.a().y(), j, lattice.b().y())};
    }
    void swap_rows() { m = {m[2], m[3], m[0], m[1]}; }
    void subtract_first(double times) {
        const auto k = static_cast<std::int64_t>(times);
        m[2] -= k * m[0];
        m[3] -= k * m[1];
    }
};

void require_small(double coefficient) {
    if (std::abs(coefficient) > kLargestCoefficient) {
        throw InvalidInput(
            "the period vectors are too close to parallel: their reduction needs integers above "
            "10^6; give a less skewed basis of the same lattice");
    }
}

}  // namespace

std::string offset_in_words(Offset offset) {
    return "(" + std::to_string(offset.i) + ", " + std::to_string(offset.j) + ")";
}

Lattice::Lattice(const Vec2& a, const Vec2& b) : a_(a), b_(b) {
    require_period(a);
    require_period(b);
    const double det = determinant(a, b);
    if (!(std::abs(det) > kParallel * a.stableNorm() * b.stableNorm())) {
        throw InvalidInput("the period vectors are parallel; give two independent ones");
    }
    area_ = std::abs(det);
    right_handed_ = det > 0;
}

Lattice Lattice::rectangle(double width, double height) {
    return {Vec2(width, 0), Vec2(0, height)};
}

Vec2 Lattice::translation(plane::Offset offset) const {
    const double i = offset.i;
    const double j = offset.j;
    return {product_sum(i, a_.x(), j, b_.x()), product_sum(i, a_.y(), j, b_.y())};
}

Vec2 Lattice::to_lattice(const Vec2& p) const {
    const double det = right_handed_ ? area_ : -area_;
    return {determinant(p, b_) / det, determinant(a_, p) / det};
}

Vec2 Lattice::to_position(const Vec2& u) const {
    return {product_sum(u.x(), a_.x(), u.y(), b_.x()), product_sum(u.x(), a_.y(), u.y(), b_.y())};
}

Lattice Lattice::repeated(int columns, int rows) const { return {columns * a_, rows * b_}; }

double Lattice::spacing(int n) const { return std::sqrt(area_ / n); }

Vec2 Lattice::wrapped(const Vec2& u) { return {wrap(u.x()).fraction, wrap(u.y()).fraction}; }

Reduction reduce(const Lattice& lattice) {
    Combination basis{lattice};
    // Shorten b by multiples of a, and exchange the two, until neither step applies.
    for (;;) {
        const Vec2 a = basis.vector(0);
        const Vec2 b = basis.vector(1);
        const double ratio = a.dot(b) / a.squaredNorm();
        const double times = std::round(ratio);
        if (std::abs(ratio) > 0.5 * kTie) {
            require_small(times);
            basis.subtract_first(times);
        } else if (b.squaredNorm() * kTie < a.squaredNorm()) {
            basis.swap_rows();
        } else {
            break;
        }
        for (const auto entry : basis.m) require_small(static_cast<double>(entry));
    }
    // Make the basis right-handed.
    if (determinant(basis.vector(0), basis.vector(1)) < 0) {
        basis.m[2] = -basis.m[2];
        basis.m[3] = -basis.m[3];
    }
    const Lattice reduced(basis.vector(0), basis.vector(1));
    if (reduced.b().norm() > kThinnestBasis * reduced.a().norm()) {
        throw InvalidInput("the lattice is thinner than 1 : 10^6; give a less extreme one");
    }
    return {reduced,
            {static_cast<int>(basis.m[0]), static_cast<int>(basis.m[1]),
             static_cast<int>(basis.m[2]), static_cast<int>(basis.m[3])}};
}

Wrapped wrap(double u) {
    constexpr double kGrid = 0x1p51;
    double whole = std::floor(u);
    double fraction = std::nearbyint((u - whole) * kGrid) / kGrid;
    if (fraction >= 1) {
        fraction -= 1;
        whole += 1;
    }
    return {fraction, static_cast<int>(whole)};
}

}  // namespace pcvt::plane
