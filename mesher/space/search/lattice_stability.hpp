#pragma once

#include "mesher/optimize/minimum.hpp"
#include "mesher/space/search/lattice_pattern.hpp"

namespace pcvt::space {

/// Decides whether a lattice of space is a local minimum of F.
///
/// Example usage:
///   const LatticeStability stability = lattice_stability(best_lattice(period, 10));
///   if (stability.minimum == Minimum::kNo) std::cout << "a saddle\n";
///
/// The Hessian is invariant under translations by lattice vectors, so on plane waves of
/// displacements e cos(k . x_s), with k one of n wave vectors, it acts as a symmetric 3 x 3 matrix:
///
///   H(k) = sum over v of (1 - cos(k . v)) K_v,   K_v = 4 / |v| (A v v^T / 4 - Q),
///
/// where v runs over the seven vectors, up to their sign, that cross the facets of the Voronoi
/// cell, A is the area of the facet, and Q the integral of q q^T over it, q relative to its centre
/// v / 2. This follows from d^2F / dx_i dx_j = 2 / |x_i - x_j| times the integral of (x_i - y)(x_j
/// - y)^T over the facet (M. Iri, K. Murota, T. Ohya 1984). The facets are sums of segments (G.
/// Voronoi 1908): with an obtuse superbase b_0 ... b_3 and its Selling parameters p_ij, segment ij
/// has the vector p_ij z_ij, where z_ij . b_k is 1 for k = i, -1 for k = j, and else 0; the facet
/// that v crosses consists of the segments perpendicular to v. Law, tested by number:
///   (1) The eigenvalues agree with differences of the gradient.
LatticeStability lattice_stability(const LatticePattern& pattern);

}  // namespace pcvt::space
