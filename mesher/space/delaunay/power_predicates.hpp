#pragma once

#include <array>
#include <cmath>

#include "mesher/space/delaunay/predicates.hpp"

namespace pcvt::space {

// The predicates of predicates.hpp for sites with weights; predicates.cpp defines both from one set
// of polynomials.

/// An image of a site with the weight of its power distance |p - x|^2 - w, in units of the Gram
/// matrix: a multiple of 2^-100 below 2^43 (rounded_weight).
///
/// Example usage (whether the facet p, q, r of two positively oriented tetrahedra p, q, r, s and q,
/// p, r, t is locally regular):
///
///     const bool regular = !violates_regularity(gram, p, q, r, s, t);
struct WeightedImage {
    Image at;
    double weight;
};

/// Weights are multiples of 2^-kWeightBits, so that predicates are exact in the integers of
/// in_sphere().
inline constexpr int kWeightBits = 100;
/// Weights of images must be smaller. Where two weights of a diagram differ by as much, the smaller
/// one has no cell, because the squares of distances are smaller.
inline constexpr double kLargestWeight = 0x1p43;

/// The nearest weight that the predicates take. It differs from the weight only below 2^-47.
/// @pre |weight| < kLargestWeight.
inline double rounded_weight(double weight) { return std::nearbyint(weight * 0x1p100) * 0x1p-100; }

/// Returns +1 if t lies below the hyperplane through the positively oriented p, q, r, s, lifted to
/// the heights |x|^2 - w, -1 if above, 0 if on it: in_sphere where all weights are equal.
int in_power_sphere(const Gram& gram, const WeightedImage& p, const WeightedImage& q,
                    const WeightedImage& r, const WeightedImage& s, const WeightedImage& t);

/// The same with ties broken by the rule of violates_delaunay(): heights are thought to be a little
/// greater, the more the greater a point is in the lexicographic order of coordinates. Among the
/// triangulations of the sites with cells exactly one satisfies the rule.
bool violates_regularity(const Gram& gram, const WeightedImage& p, const WeightedImage& q,
                         const WeightedImage& r, const WeightedImage& s, const WeightedImage& t);

/// The orthocentre, the point of equal power distance to the corners 0, d[0], d[1] and d[2], from
/// exact determinants (exact_circumcentre).
/// @param weight  of the four corners.
Vec3 exact_orthocentre(const Gram& gram, const std::array<Vec3, 3>& d,
                       const std::array<double, 4>& weight);

}  // namespace pcvt::space
