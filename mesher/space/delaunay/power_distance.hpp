#pragma once

#include "mesher/space/delaunay/predicates.hpp"

namespace pcvt::space {

/// An image of a site as seen from a point.
struct SeenImage {
    /// From the point to the image: coordinates of the reduced basis, multiples of 2^-50 in
    /// (-8, 8)^3.
    Vec3 displacement;
    /// In units of the Gram matrix: a multiple of 2^-100 below 2^43.
    double weight = 0;
};

/// Returns -1 if the power distance |displacement|^2 - weight of p is less than that of q, +1 if it
/// is greater, 0 if both are equal. Exact.
///
/// Example usage (whether a point is nearer to site 2 than to site 0):
///
///     const bool nearer = compare_power_distances(gram, {x.col(2) - p}, {x.col(0) - p}) < 0;
int compare_power_distances(const Gram& gram, const SeenImage& p, const SeenImage& q);

}  // namespace pcvt::space
