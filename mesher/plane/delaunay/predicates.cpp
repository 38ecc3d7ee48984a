#include "mesher/plane/delaunay/predicates.hpp"

#include <CGAL/MP_Float.h>

#include <cmath>

#include "mesher/plane/delaunay/power_distance.hpp"

namespace pcvt::plane {
namespace {

using Exact = CGAL::MP_Float;

constexpr double kCentreError = 32 * kUnitRoundoff;
/// A triangle with |d x e| above this fraction of its rounding scale is far from collinear: doubles
/// give its circumcentre to twelve digits.
constexpr double kFarFromCollinear = 1e-3;

int sign(double x) { return (x > 0) - (x < 0); }
int sign(const Exact& x) { return CGAL::sign(x); }

/// The polynomials of the predicates, in double for the filter and in MP_Float for the exact value.
/// A `_bound` function evaluates the same polynomial with absolute values and sums only: the scale
/// of its rounding.
template <class Number>
struct Vector {
    Number u;
    Number v;
    /// The weight of the end minus that of the origin.
    Number weight;
};

template <class Number>
Vector<Number> vector(const WeightedImage& p, const WeightedImage& q) {
    return {(Number(q.at.u) - Number(p.at.u)) + Number(q.at.offset.i - p.at.offset.i),
            (Number(q.at.v) - Number(p.at.v)) + Number(q.at.offset.j - p.at.offset.j),
            Number(q.weight) - Number(p.weight)};
}

Vector<double> absolute(const Vector<double>& d) {
    return {std::abs(d.u), std::abs(d.v), -std::abs(d.weight)};
}
Gram absolute(const Gram& g) { return {g.aa, std::abs(g.ab), g.bb}; }

template <class Number>
Number cross(const Vector<Number>& d, const Vector<Number>& e) {
    return d.u * e.v - d.v * e.u;
}

double cross_bound(const Vector<double>& d, const Vector<double>& e) {
    return d.u * e.v + d.v * e.u;
}

/// |d|^2 - w: the height of the end above the origin on the paraboloid that weights lower.
template <class Number>
Number height(const Gram& g, const Vector<Number>& d) {
    const Number twice_ab = Number(2) * Number(g.ab);
    return Number(g.aa) * d.u * d.u + twice_ab * d.u * d.v + Number(g.bb) * d.v * d.v - d.weight;
}

template <class Number>
Number in_circle_value(const Gram& g, const Vector<Number>& p, const Vector<Number>& q,
                       const Vector<Number>& r) {
    return height(g, p) * cross(q, r) + height(g, q) * cross(r, p) + height(g, r) * cross(p, q);
}

/// The orthocentre c of the triangle with corners at `corner`, corner + d, corner + e solves 2
/// G(d, c - corner) = height(d), and the same equation for e. centre_u returns det(G) (d x e) 2 (c
/// - line) for one coordinate of c, where `line` is 0 or 1.
template <class Number>
Number centre_u(const Gram& g, const Vector<Number>& d, const Vector<Number>& e, Number corner) {
    const Number det = Number(g.aa) * Number(g.bb) - Number(g.ab) * Number(g.ab);
    const Number gd = Number(g.ab) * d.u + Number(g.bb) * d.v;
    const Number ge = Number(g.ab) * e.u + Number(g.bb) * e.v;
    return height(g, d) * ge - height(g, e) * gd + Number(2) * det * cross(d, e) * corner;
}

double centre_u_bound(const Gram& g, const Vector<double>& d, const Vector<double>& e,
                      double corner) {
    return height(g, d) * (g.ab * e.u + g.bb * e.v) + height(g, e) * (g.ab * d.u + g.bb * d.v) +
           2 * (g.aa * g.bb + g.ab * g.ab) * cross_bound(d, e) * corner;
}

bool differences_exact(const Vector<double>& d) {
    return std::abs(d.u) < kExactDifference && std::abs(d.v) < kExactDifference;
}

/// The sign of the orthocentre's first coordinate minus `line`.
int centre_side(const Gram& g, const WeightedImage& p, const WeightedImage& q,
                const WeightedImage& r, int line) {
    ++detail::predicate_counts.calls;
    const auto d = vector<double>(p, q);
    const auto e = vector<double>(p, r);
    const double corner = p.at.u + (p.at.offset.i - line);
    if (differences_exact(d) && differences_exact(e) && std::abs(corner) < kExactDifference) {
        const double value = centre_u(g, d, e, corner);
        const double bound =
            centre_u_bound(absolute(g), absolute(d), absolute(e), std::abs(corner));
        if (std::abs(value) > kCentreError * bound + detail::kSmallestBound) return sign(value);
    }
    ++detail::predicate_counts.exact;
    return sign(centre_u<Exact>(g, vector<Exact>(p, q), vector<Exact>(p, r),
                                Exact(p.at.u) + Exact(p.at.offset.i - line)));
}

/// The same triangle with its two coordinates exchanged, which turns counter-clockwise into
/// clockwise; callers therefore exchange two corners as well.
WeightedImage transposed(const WeightedImage& p) {
    return {{p.at.v, p.at.u, p.at.site, {p.at.offset.j, p.at.offset.i}}, p.weight};
}

Vector<double> transposed(const Vector<double>& d) { return {d.v, d.u, d.weight}; }
Gram transposed(const Gram& g) { return {g.bb, g.ab, g.aa}; }

/// The orthocentre relative to the common corner of d and e, with products evaluated in `Number`.
template <class Number>
Vec2 centre(const Gram& g, const Vector<double>& d, const Vector<double>& e) {
    const auto widen = [](const Vector<double>& x) {
        return Vector<Number>{Number(x.u), Number(x.v), Number(x.weight)};
    };
    const Vector<Number> dn = widen(d);
    const Vector<Number> en = widen(e);
    const Number det = Number(g.aa) * Number(g.bb) - Number(g.ab) * Number(g.ab);
    const auto u = centre_u<Number>(g, dn, en, Number(0));
    const auto v =
        centre_u<Number>(transposed(g), widen(transposed(e)), widen(transposed(d)), Number(0));
    const double divisor = CGAL::to_double(Number(Number(2) * det * cross(dn, en)));
    return {CGAL::to_double(u) / divisor, CGAL::to_double(v) / divisor};
}

WeightedImage weightless(const Image& p) { return {p, 0}; }

}  // namespace

namespace detail {

constinit thread_local PredicateCounts predicate_counts;

int exact_orientation(const Image& p, const Image& q, const Image& r) {
    ++predicate_counts.exact;
    return sign(cross(vector<Exact>(weightless(p), weightless(q)),
                      vector<Exact>(weightless(p), weightless(r))));
}

int exact_in_circle(const Gram& gram, const Image& p, const Image& q, const Image& r,
                    const Image& s) {
    return exact_in_power_circle(gram, weightless(p), weightless(q), weightless(r), weightless(s));
}

int exact_in_power_circle(const Gram& gram, const WeightedImage& p, const WeightedImage& q,
                          const WeightedImage& r, const WeightedImage& s) {
    ++predicate_counts.exact;
    return sign(
        in_circle_value(gram, vector<Exact>(s, p), vector<Exact>(s, q), vector<Exact>(s, r)));
}

int exact_compare_power_distances(const Gram& gram, const Image& at, const WeightedImage& p,
                                  const WeightedImage& q) {
    ++predicate_counts.exact;
    const WeightedImage from = weightless(at);
    const Exact to_p = height(gram, vector<Exact>(from, p));
    return sign(Exact(to_p - height(gram, vector<Exact>(from, q))));
}

}  // namespace detail

double gram_unit(const Lattice& reduced) {
    int exponent = 0;
    std::frexp(reduced.a().norm(), &exponent);
    return std::ldexp(1.0, exponent);
}

Gram gram_of(const Lattice& reduced) {
    const double unit = gram_unit(reduced);
    const Vec2 a = reduced.a() / unit;
    const Vec2 b = reduced.b() / unit;
    return {a.squaredNorm(), a.dot(b), b.squaredNorm()};
}

bool circumcentre_in_domain(const Gram& gram, const Image& p, const Image& q, const Image& r) {
    return orthocentre_in_domain(gram, weightless(p), weightless(q), weightless(r));
}

Vec2 circumcentre(const Gram& gram, const Image& p, const Image& q, const Image& r) {
    return orthocentre(gram, weightless(p), weightless(q), weightless(r));
}

int in_power_segment(const Gram& gram, const WeightedImage& p, const WeightedImage& q,
                     const WeightedImage& s) {
    ++detail::predicate_counts.calls;
    ++detail::predicate_counts.exact;
    const auto d = vector<Exact>(s, p);
    const auto e = vector<Exact>(s, q);
    // Measure along a coordinate in which p and q differ.
    const bool along_u = sign(Exact(e.u - d.u)) != 0;
    const Exact to_p = along_u ? d.u : d.v;
    const Exact to_q = along_u ? e.u : e.v;
    return sign(Exact(to_q - to_p)) * sign(Exact(height(gram, d) * to_q - height(gram, e) * to_p));
}

bool orthocentre_in_domain(const Gram& gram, const WeightedImage& p, const WeightedImage& q,
                           const WeightedImage& r) {
    if (centre_side(gram, p, q, r, 0) < 0 || centre_side(gram, p, q, r, 1) >= 0) return false;
    const Gram exchanged = transposed(gram);
    const WeightedImage pt = transposed(p);
    const WeightedImage qt = transposed(q);
    const WeightedImage rt = transposed(r);
    return centre_side(exchanged, pt, rt, qt, 0) >= 0 && centre_side(exchanged, pt, rt, qt, 1) < 0;
}

Vec2 orthocentre(const Gram& gram, const WeightedImage& p, const WeightedImage& q,
                 const WeightedImage& r) {
    const auto d = vector<double>(p, q);
    const auto e = vector<double>(p, r);
    const double scale = cross_bound(absolute(d), absolute(e));
    if (std::abs(cross(d, e)) > kFarFromCollinear * scale) return centre<double>(gram, d, e);
    return centre<Exact>(gram, d, e);
}

int compare_u(const Image& p, const Image& q) {
    return -sign((q.u - p.u) + (q.offset.i - p.offset.i));
}

int compare_v(const Image& p, const Image& q) {
    return -sign((q.v - p.v) + (q.offset.j - p.offset.j));
}

PredicateCounts predicate_counts() { return detail::predicate_counts; }

}  // namespace pcvt::plane
