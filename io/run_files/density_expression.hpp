#pragma once

#include <string>

#include "mesher/plane/density/density.hpp"

namespace pcvt {

/// Returns the density that a formula defines.
///
/// Variables: x, y in length units and u, v in [0, 1), see DensityPoint. formula.hpp has the
/// functions, the operators and the refusals.
///
/// Example usage:
///     const Density density = expression_density("1 + 99 * exp(-((v - 0.5) / 0.08)^2)");
///     const std::vector<double> rho = densities_at(density, lattice, points);
///
/// @throws InvalidInput as read_formula does.
plane::Density expression_density(const std::string& expression);

}  // namespace pcvt
