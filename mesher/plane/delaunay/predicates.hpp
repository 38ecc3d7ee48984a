#pragma once

#include <cmath>

#include "mesher/plane/geometry/sites.hpp"

namespace pcvt::plane {

/// An image of a site: coordinates in the reduced basis, multiples of 2^-51 in [-2, 3)^2, plus an
/// offset in the same basis.
///
/// Example usage (whether site 2 translated by b violates the Delaunay property of a triangle):
///
///     const Gram gram = gram_of(sites.reduction().reduced);
///     const Image p = image(sites, 0, {}), q = image(sites, 1, {}), r = image(sites, 3, {});
///     if (orientation(p, q, r) > 0)
///         violates = in_circle(gram, p, q, r, image(sites, 2, {0, 1})) > 0;
struct Image {
    double u;
    double v;
    SiteId site;
    Offset offset;
};

/// @param coordinates  2 x n, reduced basis.
inline Image image(const Points& coordinates, SiteId site, Offset offset) {
    return {coordinates(0, site), coordinates(1, site), site, offset};
}
inline Image image(const Sites& sites, SiteId site, Offset offset) {
    return image(sites.coordinates(), site, offset);
}

/// q - p in coordinates of the reduced basis; exact while both components are below 4.
inline Vec2 difference(const Image& p, const Image& q) {
    return {(q.u - p.u) + (q.offset.i - p.offset.i), (q.v - p.v) + (q.offset.j - p.offset.j)};
}

/// The Gram matrix of the reduced basis, scaled by a power of two and rounded once. For every
/// predicate this rounded matrix *is* the lattice, so that all images of a triangle give the same
/// answer.
struct Gram {
    double aa;
    double ab;
    double bb;
};

Gram gram_of(const Lattice& reduced);
/// The power of two that is the Gram matrix' unit of length, in units of the lattice.
double gram_unit(const Lattice& reduced);

/// Calls of predicates on this thread, and how many of them the filter could not decide.
struct PredicateCounts {
    std::int64_t calls = 0;
    std::int64_t exact = 0;
};
PredicateCounts predicate_counts();

/// Half an ulp of 1. An error bound counts the roundings along the longest chain of its expression
/// and is then rounded up generously: the filter fails a little more often but never errs.
inline constexpr double kUnitRoundoff = 0x1p-53;
inline constexpr double kOrientationError = 4 * kUnitRoundoff;
inline constexpr double kInCircleError = 16 * kUnitRoundoff;
/// Components of a difference from this size on may be rounded, so the filter is skipped.
inline constexpr double kExactDifference = 4;

namespace detail {

extern constinit thread_local PredicateCounts predicate_counts;

int exact_orientation(const Image& p, const Image& q, const Image& r);
int exact_in_circle(const Gram& gram, const Image& p, const Image& q, const Image& r,
                    const Image& s);

inline bool is_exact(const Vec2& d) {
    return std::abs(d.x()) < kExactDifference && std::abs(d.y()) < kExactDifference;
}

inline double cross(const Vec2& d, const Vec2& e) { return d.x() * e.y() - d.y() * e.x(); }

/// The rounding scale of the cross product: absolute values and sums only.
inline double cross_bound(const Vec2& d, const Vec2& e) {
    return std::abs(d.x() * e.y()) + std::abs(d.y() * e.x());
}

/// Cross and dot product of two sides, which are |d| |e| times the sine and the cosine of their
/// angle up to a constant factor, and the rounding scales of both.
struct Angle {
    double cross;
    double dot;
    double cross_bound;
    double dot_bound;
};

inline Angle angle(const Gram& g, const Vec2& d, const Vec2& e) {
    const double uu = d.x() * e.x();
    const double uv = d.x() * e.y();
    const double vu = d.y() * e.x();
    const double vv = d.y() * e.y();
    const double cross_bound = std::abs(uv) + std::abs(vu);
    return {uv - vu, g.aa * uu + g.ab * (uv + vu) + g.bb * vv, cross_bound,
            g.aa * std::abs(uu) + std::abs(g.ab) * cross_bound + g.bb * std::abs(vv)};
}

/// Returns a positive value if s certainly lies inside the circle through p, q, r, a negative value
/// if s certainly lies outside, and 0 if rounding decides. The arguments are the exact differences
/// of p and q to r and s.
inline double in_circle_filter(const Gram& gram, const Vec2& rp, const Vec2& rq, const Vec2& sp,
                               const Vec2& sq) {
    // The sine of the sum of the angles at which r and s see the edge p q: the same polynomial as
    // the usual determinant.
    const Angle at_r = angle(gram, rp, rq);
    const Angle at_s = angle(gram, sq, sp);
    const double value = at_r.cross * at_s.dot + at_r.dot * at_s.cross;
    const double bound =
        kInCircleError * (at_r.cross_bound * at_s.dot_bound + at_r.dot_bound * at_s.cross_bound);
    return std::abs(value) > bound ? -value : 0;
}

}  // namespace detail

/// The predicates are exact: a double filter decides nearly all cases, multiprecision the others.
/// They depend only on differences of images, so a common translation never changes an answer.

/// Returns +1 if p, q, r turn counter-clockwise, -1 if clockwise, 0 if they are collinear.
inline int orientation(const Image& p, const Image& q, const Image& r) {
    ++detail::predicate_counts.calls;
    const Vec2 d = difference(p, q);
    const Vec2 e = difference(p, r);
    if (detail::is_exact(d) && detail::is_exact(e)) {
        const double value = detail::cross(d, e);
        const double bound = kOrientationError * detail::cross_bound(d, e);
        if (value > bound) return 1;
        if (value < -bound) return -1;
    }
    return detail::exact_orientation(p, q, r);
}

/// Returns +1 if s lies inside the circle through the counter-clockwise triangle p, q, r, -1 if
/// outside, 0 if on it.
inline int in_circle(const Gram& gram, const Image& p, const Image& q, const Image& r,
                     const Image& s) {
    ++detail::predicate_counts.calls;
    const Vec2 rp = difference(r, p);
    const Vec2 rq = difference(r, q);
    const Vec2 sp = difference(s, p);
    const Vec2 sq = difference(s, q);
    if (detail::is_exact(rp) && detail::is_exact(rq) && detail::is_exact(sp) &&
        detail::is_exact(sq)) {
        const double sign = detail::in_circle_filter(gram, rp, rq, sp, sq);
        if (sign != 0) return sign > 0 ? 1 : -1;
    }
    return detail::exact_in_circle(gram, p, q, r, s);
}

/// Whether the circumcentre of the counter-clockwise triangle p, q, r lies in the half-open domain
/// [0, 1)^2. This holds for exactly one of all images of a triangle.
bool circumcentre_in_domain(const Gram& gram, const Image& p, const Image& q, const Image& r);

/// The circumcentre of the counter-clockwise triangle p, q, r minus p, in coordinates of the
/// reduced basis. The relative error is below 1e-12 for triangles of any thinness.
Vec2 circumcentre(const Gram& gram, const Image& p, const Image& q, const Image& r);

/// Compare the coordinates u + i and v + j, respectively: -1, 0 or +1.
int compare_u(const Image& p, const Image& q);
int compare_v(const Image& p, const Image& q);

}  // namespace pcvt::plane
