#pragma once

#include "mesher/base/block_matrix.hpp"
#include "mesher/lattice/sites.hpp"

namespace pcvt {

/// What the Hessian says of a state whose gradient is zero. Its eigenvalues, apart from the two
/// translations, lie all above a millionth of the largest one (`kYes`), some below minus that
/// (`kNo`), or neither.
enum class Minimum { kYes, kNo, kUnknown };

/// "yes", "no", "unknown".
const char* minimum_name(Minimum minimum);

/// Sites up to which the answer, where it is yes, takes less than half a second.
inline constexpr int kMostSitesForStability = 10'000;

/// By Sylvester's law of inertia: the number of negative pivots of H - s is the number of
/// eigenvalues of H below s. One sparse factorisation where the answer is yes, else two, each of
/// the order n^1.5. One site has one state modulo translations: a minimum.
/// @param hessian  annihilates translations.
Minimum stability(const BlockMatrix& hessian);

/// Of sites at rest, for rho = 1; triangulates them.
Minimum stability(const Sites& sites);

}  // namespace pcvt
