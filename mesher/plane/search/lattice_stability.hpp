#pragma once

#include "mesher/optimize/minimum.hpp"
#include "mesher/plane/search/lattice_pattern.hpp"

namespace pcvt::plane {

/// Decides whether a lattice is a local minimum of F.
///
/// Example usage:
///   const LatticeStability stability = lattice_stability(best_lattice(period, 30));
///   if (stability.minimum == Minimum::kNo) std::cout << "a saddle\n";
///
/// The Hessian is invariant under translations by lattice vectors, so on plane waves of
/// displacements e cos(k . x_s), with k one of n wave vectors, it acts as a symmetric 2 x 2 matrix:
///
///   H(k) = sum over v of (1 - cos(k . v)) c (v v^T - c^2 / 3  w w^T),  w = v turned by 90 degrees,
///
/// where v runs over the three vectors of the obtuse superbase, and c = (length of the Voronoi edge
/// that v crosses) / |v|. This follows from d^2F / dx_i dx_j = 2 / |x_i - x_j| times the integral
/// of (x_i - y)(x_j - y)^T over the edge, whose midpoint is the midpoint of x_i and x_j. Law,
/// tested by number:
///   (1) The eigenvalues agree with differences of the gradient.
LatticeStability lattice_stability(const LatticePattern& pattern);

}  // namespace pcvt::plane
