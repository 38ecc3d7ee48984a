#pragma once

#include "mesher/plane/delaunay/power_predicates.hpp"

namespace pcvt::plane {
namespace detail {

/// Error bound of |d|^2 - w: three roundings of the largest term, then one for each of four sums.
inline constexpr double kPowerDistanceError = 8 * kUnitRoundoff;

int exact_compare_power_distances(const Gram& gram, const Image& at, const WeightedImage& p,
                                  const WeightedImage& q);

/// |d|^2 - weight, and the scale of its rounding.
struct PowerDistance {
    double value;
    double bound;
};

inline PowerDistance power_distance(const Gram& gram, const Vec2& d, double weight) {
    const double uu = d.x() * d.x();
    const double uv = 2 * d.x() * d.y();
    const double vv = d.y() * d.y();
    return {gram.aa * uu + gram.ab * uv + gram.bb * vv - weight,
            gram.aa * uu + std::abs(gram.ab * uv) + gram.bb * vv + std::abs(weight)};
}

}  // namespace detail

/// Returns -1 if the power distance |at - x|^2 - w to p is less than that to q, +1 if it is
/// greater, 0 if both are equal. Exact for any finite weights.
///
/// Example usage (whether a point is nearer to site 2 than to site 0):
///
///     const bool nearer = compare_power_distances(gram, point, {image(sites, 2, {}), w2},
///                                                 {image(sites, 0, {}), w0}) < 0;
///
/// @param at  a point, which has the form of an image; its site is not used.
inline int compare_power_distances(const Gram& gram, const Image& at, const WeightedImage& p,
                                   const WeightedImage& q) {
    ++detail::predicate_counts.calls;
    const Vec2 to_p = difference(at, p.at);
    const Vec2 to_q = difference(at, q.at);
    if (detail::is_exact(to_p) && detail::is_exact(to_q)) {
        const detail::PowerDistance of_p = detail::power_distance(gram, to_p, p.weight);
        const detail::PowerDistance of_q = detail::power_distance(gram, to_q, q.weight);
        const double value = of_p.value - of_q.value;
        const double bound =
            detail::kPowerDistanceError * (of_p.bound + of_q.bound) + detail::kSmallestBound;
        if (std::abs(value) > bound) return value > 0 ? 1 : -1;
    }
    return detail::exact_compare_power_distances(gram, at, p, q);
}

}  // namespace pcvt::plane
