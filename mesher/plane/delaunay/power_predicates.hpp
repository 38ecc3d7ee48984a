#pragma once

#include "mesher/plane/delaunay/predicates.hpp"

namespace pcvt::plane {

// The predicates of predicates.hpp for sites with weights; predicates.cpp defines both from one set
// of polynomials.

/// An image of a site with the weight of its power distance |p - x|^2 - w, in units of the Gram
/// matrix (gram_unit(reduced)^2 units of area).
///
/// Example usage (whether edge p q of two counter-clockwise triangles p, q, r and q, p, s is
/// locally regular):
///
///     const bool regular = in_power_circle(gram, p, q, r, s) <= 0;
struct WeightedImage {
    Image at;
    double weight;
};

namespace detail {

int exact_in_power_circle(const Gram& gram, const WeightedImage& p, const WeightedImage& q,
                          const WeightedImage& r, const WeightedImage& s);

/// Products of weights below this may underflow, so rounding may decide.
inline constexpr double kSmallestBound = 0x1p-960;

/// The filter of in_power_circle: positive, negative, or 0 where rounding decides.
inline double in_power_circle_filter(const Gram& gram, const WeightedImage& p,
                                     const WeightedImage& q, const WeightedImage& r,
                                     const WeightedImage& s) {
    const Vec2 rp = difference(r.at, p.at);
    const Vec2 rq = difference(r.at, q.at);
    const Vec2 sp = difference(s.at, p.at);
    const Vec2 sq = difference(s.at, q.at);
    if (!is_exact(rp) || !is_exact(rq) || !is_exact(sp) || !is_exact(sq)) return 0;
    // The polynomial of in_circle_filter, with the weights added to the heights.
    const Angle at_r = angle(gram, rp, rq);
    const Angle at_s = angle(gram, sq, sp);
    const double wp = p.weight - s.weight;
    const double wq = q.weight - s.weight;
    const double wr = r.weight - s.weight;
    const double value = (at_r.cross * at_s.dot + at_r.dot * at_s.cross) +
                         ((wp * cross(rq, sq) + wq * cross(sp, rp)) + wr * cross(sp, sq));
    const double bound =
        kInCircleError * ((at_r.cross_bound * at_s.dot_bound + at_r.dot_bound * at_s.cross_bound) +
                          (std::abs(wp) * cross_bound(rq, sq) + std::abs(wq) * cross_bound(sp, rp) +
                           std::abs(wr) * at_s.cross_bound)) +
        kSmallestBound;
    return std::abs(value) > bound ? -value : 0;
}

}  // namespace detail

/// Returns +1 if s lies below the plane through p, q, r, lifted to the heights |x|^2 - w, -1 if
/// above, 0 if on it: in_circle where all weights are equal. The triangle p, q, r runs
/// counter-clockwise. Exact for any finite weights.
inline int in_power_circle(const Gram& gram, const WeightedImage& p, const WeightedImage& q,
                           const WeightedImage& r, const WeightedImage& s) {
    ++detail::predicate_counts.calls;
    const double sign = detail::in_power_circle_filter(gram, p, q, r, s);
    if (sign != 0) return sign > 0 ? 1 : -1;
    return detail::exact_in_power_circle(gram, p, q, r, s);
}

/// The same on a line: +1 if s lies below the segment between p and q, lifted, -1 if above.
/// @pre p, q, s are collinear and s lies between p and q, or on either side of both.
int in_power_segment(const Gram& gram, const WeightedImage& p, const WeightedImage& q,
                     const WeightedImage& s);

/// Whether the orthocentre, the point of equal power distance to p, q, r, lies in the half-open
/// domain [0, 1)^2; the triangle runs counter-clockwise. This holds for exactly one of all images.
bool orthocentre_in_domain(const Gram& gram, const WeightedImage& p, const WeightedImage& q,
                           const WeightedImage& r);

/// The orthocentre minus p, in coordinates of the reduced basis, as exact as circumcentre, to which
/// it is equal where all weights are equal.
Vec2 orthocentre(const Gram& gram, const WeightedImage& p, const WeightedImage& q,
                 const WeightedImage& r);

}  // namespace pcvt::plane
