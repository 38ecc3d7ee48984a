#include "tests/support/wide_terms.hpp"

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>

namespace pcvt::testing {
namespace {

using Wide = boost::multiprecision::cpp_bin_float_50;

struct WideVector {
    Wide x = 0;
    Wide y = 0;

    WideVector operator+(const WideVector& o) const { return {x + o.x, y + o.y}; }
    WideVector operator-(const WideVector& o) const { return {x - o.x, y - o.y}; }
    Wide dot(const WideVector& o) const { return x * o.x + y * o.y; }
    Wide cross(const WideVector& o) const { return x * o.y - y * o.x; }
    plane::Vec2 rounded() const { return {static_cast<double>(x), static_cast<double>(y)}; }
};

/// Integrals of |p|^2, p and 1 over triangles with one corner at the origin.
struct Moments {
    Wide square = 0;
    WideVector first;
    Wide area = 0;

    void add(const WideVector& m, const WideVector& c) {
        const Wide cross = m.cross(c);
        const WideVector sum = m + c;
        square += cross / 12 * (m.dot(m) + m.dot(c) + c.dot(c));
        first = first + WideVector{cross / 6 * sum.x, cross / 6 * sum.y};
        area += cross / 2;
    }
};

void add_sizes(const Moments& part, double half_side, WideTerms& terms) {
    terms.value_size += std::abs(static_cast<double>(part.square)) + std::pow(half_side, 4);
    terms.gradient_size += 2 * part.first.rounded().norm() + std::pow(half_side, 3);
    terms.mass_size += std::abs(static_cast<double>(part.area)) + std::pow(half_side, 2);
}

WideVector circumcentre(const WideVector& p, const WideVector& q) {
    const Wide det = 2 * p.cross(q);
    const Wide pp = p.dot(p);
    const Wide qq = q.dot(q);
    return {(pp * q.y - qq * p.y) / det, (qq * p.x - pp * q.x) / det};
}

}  // namespace

WideTerms wide_terms(const plane::Vec2& p, const plane::Vec2& q, const plane::ReducedFrame& frame) {
    const auto plane = [&frame](const plane::Vec2& u) {
        return WideVector{Wide(frame.ax) * u.x() + Wide(frame.bx) * u.y(), Wide(frame.by) * u.y()};
    };
    const std::array<WideVector, 3> x{WideVector{}, plane(p), plane(q)};
    const WideVector centre = circumcentre(x[1], x[2]);
    WideTerms terms;
    Wide value = 0;
    for (int k = 0; k < 3; ++k) {
        const WideVector to_next = x[(k + 1) % 3] - x[k];
        const WideVector to_previous = x[(k + 2) % 3] - x[k];
        Moments ahead;
        ahead.add({to_next.x / 2, to_next.y / 2}, centre - x[k]);
        add_sizes(ahead, to_next.rounded().norm() / 2, terms);
        Moments behind;
        behind.add(centre - x[k], {to_previous.x / 2, to_previous.y / 2});
        add_sizes(behind, to_previous.rounded().norm() / 2, terms);
        value += ahead.square + behind.square;
        terms.gradient[k] = -2 * (ahead.first + behind.first).rounded();
        terms.mass[k] = static_cast<double>(Wide(ahead.area + behind.area));
    }
    terms.value = static_cast<double>(value);
    return terms;
}

}  // namespace pcvt::testing
