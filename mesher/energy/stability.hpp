#pragma once

#include "mesher/base/block_matrix.hpp"
#include "mesher/lattice/sites.hpp"

namespace pcvt {

/// Whether a stationary point is a minimum, according to its Hessian. Apart from the two
/// translations, all eigenvalues are above a millionth of the largest (`kYes`), some are below
/// minus that threshold (`kNo`), or neither holds (`kUnknown`).
///
/// Example usage:
///
///     const Minimum minimum = stability(result.delaunay.sites());
///     std::cout << "minimum: " << minimum_name(minimum) << '\n';
enum class Minimum { kYes, kNo, kUnknown };

/// Returns "yes", "no" or "unknown".
const char* minimum_name(Minimum minimum);

/// The number of sites up to which the answer `kYes` takes less than a second: about twice the time
/// of the optimisation.
inline constexpr int kMostSitesForStability = 10'000;

/// Counts eigenvalues by Sylvester's law of inertia: the number of negative pivots of H - s is the
/// number of eigenvalues of H below s. The cost is one sparse factorisation for the answer `kYes`,
/// else two, each of order n^1.5. One site is always a minimum, since it has a single state modulo
/// translations.
/// @param hessian  annihilates translations.
Minimum stability(const BlockMatrix& hessian);

/// The stability of stationary sites for rho = 1; triangulates them.
Minimum stability(const Sites& sites);

}  // namespace pcvt
