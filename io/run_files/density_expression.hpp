#pragma once

#include <string>

#include "mesher/plane/density/density.hpp"

namespace pcvt {

/// Returns the density that a formula defines.
///
/// Variables: x, y in length units and u, v in [0, 1), see DensityPoint; constants pi, _pi and _e;
/// operators + - * / ^, comparisons, && || and `if ? then : else`; functions sin cos tan asin acos
/// atan atan2 sinh cosh tanh asinh acosh atanh exp ln log (both natural) log2 log10 sqrt abs sign
/// rint min max sum avg. Numbers have a decimal point in every locale. Blanks, tabs and line ends
/// separate; other control characters and all that is not ASCII are refused.
///
/// Example usage:
///     const Density density = expression_density("1 + 99 * exp(-((v - 0.5) / 0.08)^2)");
///     const std::vector<double> rho = densities_at(density, lattice, points);
///
/// @throws InvalidInput `character 7: problem; remedy`, with characters counted from 1.
plane::Density expression_density(const std::string& expression);

}  // namespace pcvt
