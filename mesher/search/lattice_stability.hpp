#pragma once

#include <optional>

#include "mesher/energy/stability.hpp"
#include "mesher/search/lattice_pattern.hpp"

namespace pcvt {

/// Eigenvalues of the Hessian of F at a lattice, without the two translations.
struct LatticeStability {
    Minimum minimum;
    /// The smallest one over the largest; nothing for n = 1, which has only the translations.
    std::optional<double> smallest;
};

/// The Hessian does not change when the lattice moves by one of its own vectors, so a plane wave
/// x_s -> e cos(k . x_s), with k one of n wave vectors, meets a symmetric 2 x 2 matrix:
///
///   H(k) = sum over v of (1 - cos(k . v)) c (v v^T - c^2 / 3  w w^T),  w = v turned by 90 degrees,
///
/// v the three vectors of the obtuse superbase, c = (length of the Voronoi edge that v crosses) /
/// |v|. It follows from d^2F / dx_i dx_j = 2 / |x_i - x_j| times the integral of (x_i - y)(x_j -
/// y)^T over the edge, whose middle is that of x_i and x_j. Law, tested by number:
///   (1) It agrees with differences of the gradient.
LatticeStability lattice_stability(const LatticePattern& pattern);

}  // namespace pcvt
