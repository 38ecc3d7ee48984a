#pragma once

#include "mesher/base/block_matrix.hpp"
#include "mesher/optimize/minimum.hpp"

namespace pcvt {

/// Decides whether a stationary point is a minimum by Sylvester's law of inertia: the number of
/// negative pivots of H - s is the number of eigenvalues of H below s. The cost is one sparse
/// factorisation for the answer `kYes`, else two.
///
/// Example usage:
///
///     const Minimum minimum = minimum_by_inertia(hessian, 2);
///     std::cout << "minimum: " << minimum_name(minimum) << '\n';
///
/// @param hessian         annihilates the translations.
/// @param n_translations  the dimension of their space.
Minimum minimum_by_inertia(const BlockMatrix& hessian, int n_translations);

}  // namespace pcvt
