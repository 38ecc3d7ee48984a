#pragma once

#include "mesher/base/block_matrix.hpp"
#include "mesher/optimize/minimum.hpp"
#include "mesher/plane/geometry/sites.hpp"

namespace pcvt::plane {

/// The number of sites up to which the answer `kYes` takes less than a second: about twice the time
/// of the optimisation.
inline constexpr int kMostSitesForStability = 10'000;

/// Counts eigenvalues (inertia.hpp); each factorisation costs of order n^1.5. One site is always a
/// minimum, since it has a single state modulo translations.
///
/// Example usage:
///
///     const Minimum minimum = stability(result.delaunay.sites());
///     std::cout << "minimum: " << minimum_name(minimum) << '\n';
///
/// @param hessian  annihilates translations.
Minimum stability(const BlockMatrix& hessian);

/// The stability of stationary sites for rho = 1; triangulates them.
Minimum stability(const Sites& sites);

}  // namespace pcvt::plane
